// What the program put into the page, and small helpers that the other scripts use.

const data = JSON.parse(document.getElementById("data").textContent);
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

/** An HTML element. Attributes that are functions become listeners; false and null are left out. */
function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (typeof value === "function") element.addEventListener(name, value);
        else if (value === true) element.setAttribute(name, "");
        else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
    }
    element.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
    return element;
}

/** An SVG element. */
function svg(tag, attributes = {}, ...children) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
}

/** A number for people: so many significant digits, a true minus, no exponent where it can be avoided. */
function shown(value, digits = 3, sign = false) {
    if (value === null || value === undefined || !Number.isFinite(value)) return "–";
    const size = Math.abs(value);
    let text = size !== 0 && (size < 1e-3 || size >= 1e7) ? size.toExponential(digits - 1)
        : size.toLocaleString("en", { maximumSignificantDigits: Math.max(digits, Math.ceil(Math.log10(size + 1))),
            useGrouping: false });
    if (value < 0 && Number(text) !== 0) text = "−" + text;
    else if (sign && Number(text) !== 0) text = "+" + text;
    return text;
}

/** A number with so many decimals and a true minus. */
function fixed(value, decimals, sign = false) {
    if (value === null || value === undefined || !Number.isFinite(value)) return "–";
    const text = Math.abs(value).toFixed(decimals);
    const nonzero = Number(text) !== 0;
    return (value < 0 && nonzero ? "−" : sign && nonzero ? "+" : "") + text;
}

/** A length of time for people. */
function duration(seconds) {
    if (!Number.isFinite(seconds)) return "–";
    if (seconds < 60) return `${shown(seconds)} s`;
    const minutes = Math.round(seconds / 60);
    if (minutes < 60) return `${minutes} min`;
    const rest = minutes % 60;
    return `${Math.floor(minutes / 60)} h` + (rest ? ` ${String(rest).padStart(2, "0")} min` : "");
}

/** An energy in MJ with three digits. */
const megajoules = (joules) => `${(joules / 1e6).toPrecision(3)} MJ`;

const words = (name) => name.replaceAll("_", " ");

/** The cells of a line of CSV (RFC 4180). */
function csvCells(line) {
    const cells = [];
    for (let at = 0; at <= line.length;) {
        if (line[at] === "\"") {
            let text = "";
            for (++at; at < line.length && !(line[at] === "\"" && line[at + 1] !== "\""); ++at) {
                if (line[at] === "\"") ++at;
                text += line[at];
            }
            cells.push(text);
            at += 2;
        } else {
            const end = line.indexOf(",", at);
            cells.push(line.slice(at, end < 0 ? undefined : end));
            at = end < 0 ? line.length + 1 : end + 1;
        }
    }
    return cells;
}

/** What stands in the braces of a heading of the schema, in a heading like it: "pin" of "pin heat". */
function nameIn(pattern, heading) {
    const [before, behind] = pattern.split(/\{.*\}/);
    return behind === undefined ? "" : heading.replace(/^'(?=[=+@-])/, "").slice(before.length, behind.length ? -behind.length : undefined);
}

/** A table of numbers as a list of { kind, name, unit, values }; null where there is none. `of` is the name in the heading. */
function parseCsv(text, file) {
    if (!text) return null;
    const all = text.split("\n").filter((line) => line);
    const lines = all.filter((line) => !line.startsWith("#"));
    const kinds = all.findLast((line) => line.startsWith("# columns: ")).slice("# columns: ".length).split(", ");
    const columns = csvCells(lines[0]).map((cell, i) => {
        const [, name, unit] = cell.match(/^(.*?)(?: \[([^\]]*)\])?$/);
        return { kind: kinds[i], of: nameIn(data.schema.columns[file][kinds[i]], name), name, unit: unit ?? "",
            values: new Float64Array(lines.length - 1) };
    });
    lines.slice(1).forEach((line, row) => csvCells(line).forEach((cell, i) => {
        if (columns[i]) columns[i].values[row] = cell === "" ? NaN : Number(cell);
    }));
    return columns;
}

/** The values of a column by its kind in the schema, and the name in its heading where it has one. */
const column = (table, kind, of = "") => table?.find((entry) => entry.kind === kind && entry.of === of)?.values;
const gapName = Object.keys(data.schema.dimensions)[0];
const columnsOf = (table, ...kinds) => (table ?? []).filter((entry) => kinds.includes(entry.kind));

/** 16-bit numbers, little-endian, from base64. */
function unpacked(text) {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const numbers = new DataView(bytes.buffer);
    return Uint16Array.from({ length: bytes.length / 2 }, (_, i) => numbers.getUint16(2 * i, true));
}

/** The values of a quantised array: low + step times number. */
const restored = ({ low, step, data: text }) => Float32Array.from(unpacked(text), (number) => low + step * number);

/** The value of a row of a table at any place between its rows (linear). */
function between(x, y, at) {
    if (at <= x[0]) return y[0];
    for (let i = 1; i < x.length; ++i)
        if (at <= x[i]) return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
    return y[y.length - 1];
}

/** Round positions (1, 2 or 5 times a power of ten apart) that cover low..high. */
function niceTicks(low, high, wanted) {
    if (!(high > low)) return [low];
    const raw = (high - low) / wanted;
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = power * [1, 2, 5, 10].find((lead) => raw <= lead * power * 1.001);
    const ticks = [];
    for (let i = Math.floor(low / step + 1e-9); i <= Math.ceil(high / step - 1e-9); ++i) ticks.push(i * step);
    return ticks;
}

/** One result folder, its tables read. */
function readRun(raw) {
    const facts = raw.summary ?? raw.loads;
    const run = { ...raw, facts, history: parseCsv(raw.history, "history.csv"),
        contributions: parseCsv(raw.contributions, "contributions.csv"), gaps: parseCsv(raw.gaps, "gaps.csv"),
        joints: parseCsv(raw.joints, "joints.csv"), bearings: parseCsv(raw.bearings, "bearings.csv") };
    run.hours = column(run.history, "time")?.map((second) => second / 3600);
    return run;
}
const runs = data.runs.map(readRun);
