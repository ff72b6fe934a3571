// Line charts, waterfalls and bars. They are drawn again for every width, so that text stays readable on a phone, and
// once for paper. Lines differ by colour (Okabe and Ito), dashes and name, so that they can be told apart without colour.

const palette = ["#0072b2", "#d55e00", "#009e73", "#b5548a", "#56b4e9", "#c98a00", "#222222"];
const dashes = ["", "7 4", "2 3", "10 3 2 3", "14 5", "5 2 1 2 1 2", "1 3"];
const symbols = ["circle", "square", "triangle", "diamond", "star", "times", "plus"];
const style = (i) => ({
    colour: palette[i % palette.length],
    dash: dashes[(i + Math.floor(i / palette.length)) % dashes.length],
    symbol: symbols[i % symbols.length],
});
const narrow = 560;
const paperWidth = 680;
const figures = [];
let paper = false;

/** A figure with heading and text; `draw(width)` gives what it shows. */
function figure(id, title, text, draw, after = null, level = "h3") {
    const drawing = make("div", { class: "drawing" });
    const element = make("figure", { "data-chart": id }, make("figcaption", {}, make(level, {}, title),
        text ? make("p", {}, text) : null), drawing, after);
    const entry = { element, width: 0, redraw(force) {
        const width = paper ? paperWidth : Math.floor(drawing.clientWidth);
        if (width < 50 || (!force && width === entry.width)) return;
        entry.width = width;
        drawing.replaceChildren(...[draw(width)].flat());
    } };
    figures.push(entry);
    return element;
}

const redrawFigures = (force = false) => figures.filter((entry) => entry.element.isConnected)
    .forEach((entry) => entry.redraw(force));
addEventListener("resize", () => requestAnimationFrame(() => redrawFigures()));
addEventListener("beforeprint", () => { paper = true; redrawFigures(true); });
addEventListener("afterprint", () => { paper = false; redrawFigures(true); });

/** Heights of labels near the wanted heights, at least `pitch` apart. */
function spreadLabels(wanted, pitch, low, high) {
    const order = wanted.map((_, i) => i).sort((a, b) => wanted[a] - wanted[b]);
    const result = [...wanted];
    let least = low;
    for (const i of order) { result[i] = Math.max(result[i], least); least = result[i] + pitch; }
    let most = high;
    for (const i of order.reverse()) { result[i] = Math.min(result[i], most); most = result[i] - pitch; }
    return result;
}

function lineSample({ colour, dash }, bold) {
    return svg("svg", { width: 34, height: 10, "aria-hidden": "true" }, svg("line", { x1: 1, x2: 33, y1: 5, y2: 5,
        stroke: colour, "stroke-width": bold ? 3.2 : 2, "stroke-dasharray": dash }));
}

/** The content of a chart as a table, for screen readers and for reading numbers. */
function figuresTable(series, xName, yUnit, xFormat) {
    const at = (list, pick) => {
        let best = -1;
        list.y.forEach((value, i) => {
            if (Number.isFinite(value) && (best < 0 || pick(value, list.y[best]))) best = i;
        });
        return best < 0 ? "–" : `${shown(list.y[best], 4)} (${xFormat(list.x[best])})`;
    };
    return make("details", {}, make("summary", {}, "Figures of this chart"), make("div", { class: "wide" },
        make("table", {},
            make("thead", {}, make("tr", {}, ["", "at the start", "smallest", "largest", "at the end"]
                .map((title) => make("th", { scope: "col" }, title)))),
            make("tbody", {}, series.map((list) => make("tr", {}, make("th", { scope: "row" }, list.name),
                make("td", {}, shown(list.y[0], 4)), make("td", {}, at(list, (a, b) => a < b)),
                make("td", {}, at(list, (a, b) => a > b)), make("td", {}, shown(list.y[list.y.length - 1], 4))))))),
    make("p", { class: "note" }, `Values in ${yUnit}; their place in brackets, in ${xName}.`));
}

/**
 * Lines over a common axis.
 * xFormat: how a place on the axis is written.
 * dots: the values are known at the points only, which are marked.
 * series: { name, x, y, bold, style: index of colour and dash, marks: [{ x, y }] published or measured values }
 */
function lineChart({ id, title, text, x, y, series, markNote, xTicks, zero = true, dots = false, level,
    xFormat = (value) => shown(value, 4) }) {
    series = series.filter((list) => list.y && list.y.some(Number.isFinite));
    if (series.length === 0) return null;
    const look = series.map((list, i) => style(list.style ?? i));
    const [xName, xUnit] = x, [yName, yUnit] = y;
    const finite = series.flatMap((list) => [...list.y].filter(Number.isFinite)
        .concat((list.marks ?? []).map((mark) => mark.y)));
    let low = Math.min(...finite.reduce((r, v) => [Math.min(r[0], v)], [Infinity]));
    let high = finite.reduce((r, v) => Math.max(r, v), -Infinity);
    if (zero) { low = Math.min(low, 0); high = Math.max(high, 0); }
    if (low > -0.005 * high && low <= 0) low = zero ? 0 : low;
    if (high === low) { high += 0.5; low -= 0.5; }
    const ticks = niceTicks(low, high, 7);
    [low, high] = [ticks[0], ticks[ticks.length - 1]];
    const xs = series.flatMap((list) => [list.x[0], list.x[list.x.length - 1]]);
    const [left, right] = [Math.min(...xs), Math.max(...xs)];
    const points = series.flatMap((list, i) => Array.from(list.y, (value, k) => ({ i, x: list.x[k], y: value })))
        .filter((point) => Number.isFinite(point.y));
    const beside = (width) => width >= narrow && series.length <= 20;

    const draw = (width) => {
        const height = Math.round(Math.min(420, Math.max(250, width * 0.5)));
        const top = 26, bottom = 42;
        const longest = Math.max(...series.map((list) => list.name.length));
        const perPixel = (high - low) / (height - top - bottom);
        const last = series.map((list) => {
            let k = list.y.length - 1;
            while (k > 0 && !Number.isFinite(list.y[k])) --k;
            return k;
        });
        const ends = series.map((list, i) => list.y[last[i]]);
        const places = spreadLabels(ends, 15 * perPixel, low, high);
        const marks = series.map((list, i) => Libraries.line(Array.from(list.y, (value, k) => [list.x[k], value]), {
            stroke: look[i].colour, strokeWidth: list.bold ? 3.2 : 1.9, strokeDasharray: look[i].dash || undefined,
            strokeLinejoin: "round", className: "series" }));
        if (dots) series.forEach((list, i) => marks.push(Libraries.dot(Array.from(list.y, (value, k) => [list.x[k], value]), {
            r: 3.2, fill: look[i].colour, stroke: look[i].colour, symbol: look[i].symbol })));
        series.forEach((list, i) => list.marks?.length && marks.push(Libraries.dot(list.marks, { x: "x", y: "y", r: 4.5,
            fill: "white", stroke: look[i].colour, strokeWidth: 1.8, symbol: look[i].symbol })));
        if (beside(width)) series.forEach((list, i) => {
            const pixel = (right - left) / (width - 56 - 40 - 7.1 * longest);
            marks.push(Libraries.line([[right + 5 * pixel, ends[i]], [right + 14 * pixel, places[i]], [right + 30 * pixel,
                places[i]]], { stroke: look[i].colour, strokeWidth: list.bold ? 3.2 : 1.9,
                strokeDasharray: look[i].dash || undefined }));
            const from = list.x[last[i]];
            if (from < right) marks.push(Libraries.line([[from, ends[i]], [right + 5 * pixel, ends[i]]],
                { stroke: look[i].colour, strokeWidth: 0.7, strokeOpacity: 0.5 }));
            marks.push(Libraries.text([list.name], { x: () => right, y: () => places[i], dx: 34, textAnchor: "start",
                fontWeight: list.bold ? "bold" : undefined, fontSize: 12.5 }));
        });
        if (!paper) marks.push(Libraries.tip(points, Libraries.pointer({ x: "x", y: "y", maxRadius: 50,
            title: (point) => `${series[point.i].name}\n${shown(point.y, 4)} ${yUnit} at ${xFormat(point.x)} ${xUnit}` })));
        const plot = Libraries.plot({
            width, height, marginTop: top, marginBottom: bottom, marginLeft: 56,
            marginRight: beside(width) ? 40 + 7.1 * longest : 14,
            ariaLabel: `${title}: lines of ${series.map((list) => list.name).join(", ")}`,
            style: { fontSize: "12px", background: "transparent", overflow: "visible" },
            x: { domain: [left, right], label: `${xName} [${xUnit}]`, labelAnchor: "right", labelArrow: "none",
                ticks: xTicks ?? Math.max(4, Math.round(width / 110)), tickFormat: xFormat },
            y: { domain: [low, high], label: `${yName} [${yUnit}]`, labelArrow: "none", ticks: ticks, grid: true,
                tickFormat: (value) => shown(value, 4) },
            marks: [low < 0 && high > 0 ? Libraries.ruleY([0], { stroke: "#8a8a8a" }) : null, ...marks],
        });
        const legend = beside(width) ? [] : [make("ul", { class: "legend" }, series.map((list, i) => make("li", {},
            lineSample(look[i], list.bold), " ", list.name)))];
        return [plot, ...legend];
    };
    const note = markNote && series.some((list) => list.marks?.length)
        ? make("p", { class: "note" }, `Marks at single times: ${markNote}.`) : null;
    return figure(id, title, text, draw, make("div", {}, note, figuresTable(series, `${xName} [${xUnit}]`, yUnit, xFormat)),
        level);
}

/**
 * Horizontal bars: steps that add up to a sum, or without `total` each from zero. rows: [{ name, value }] in the order in
 * which they are shown.
 */
function waterfall({ id, title, text, unit, rows, total = null, note }) {
    let sum = 0;
    const bars = rows.map((row) => (total === null ? { ...row, from: 0, to: row.value }
        : { ...row, from: sum, to: sum += row.value }));
    if (total !== null) bars.push({ name: total, value: sum, from: 0, to: sum, total: true });
    const draw = (width) => {
        const longest = Math.max(...bars.map((bar) => bar.name.length));
        const left = Math.min(8 + 7 * longest, width * 0.42);
        const pitch = 24, top = 8, bottom = 40, right = 14;
        const height = top + bottom + pitch * bars.length;
        const ends = bars.flatMap((bar) => [bar.from, bar.to]);
        const span = Math.max(...ends) - Math.min(...ends) || 1;
        const room = span * 62 / Math.max(60, width - left - right - 124);
        const low = Math.min(...ends) - (bars.some((bar) => bar.value < 0) ? room : 0.02 * span);
        const high = Math.max(...ends) + (bars.some((bar) => bar.value > 0) ? room : 0.02 * span);
        const ticks = niceTicks(low, high, Math.max(3, Math.round((width - left) / 80)))
            .filter((tick) => tick >= low - 1e-9 * span && tick <= high + 1e-9 * span);
        const at = (value) => left + (value - low) / (high - low) * (width - left - right);
        const drawing = svg("svg", { width, height, viewBox: `0 0 ${width} ${height}`, role: "img", class: "plain",
            "aria-label": `${title}: ${bars.map((bar) => `${bar.name} ${fixed(bar.value, 1, true)}`).join(", ")} ${unit}` });
        for (const tick of ticks) {
            drawing.append(svg("line", { x1: at(tick), x2: at(tick), y1: top, y2: height - bottom,
                stroke: Math.abs(tick) < 1e-9 * span ? "#8a8a8a" : "#e3e3e3" }));
            const text = svg("text", { x: at(tick), y: height - bottom + 17, "text-anchor": "middle", class: "tick" });
            text.textContent = shown(tick, 4);
            drawing.append(text);
        }
        const axis = svg("text", { x: width - right, y: height - 6, "text-anchor": "end" });
        axis.textContent = `change of the gap [${unit}]`;
        drawing.append(axis);
        bars.forEach((bar, i) => {
            const y = top + pitch * i;
            const [a, b] = [Math.min(bar.from, bar.to), Math.max(bar.from, bar.to)];
            const closes = bar.value < 0;
            drawing.append(svg("rect", { x: at(a), y: y + 4, width: Math.max(1, at(b) - at(a)), height: pitch - 8,
                class: `bar ${bar.total ? "total" : closes ? "closes" : "opens"}`, fill: bar.total ? "#444444"
                    : closes ? "url(#hatched)" : "#0072b2", stroke: bar.total ? "#222222" : closes ? "#d55e00" : "#0072b2" }));
            if (i + 1 < bars.length && total !== null)
                drawing.append(svg("line", { x1: at(bar.to), x2: at(bar.to), y1: y + pitch - 4, y2: y + pitch + 4,
                    stroke: "#8a8a8a" }));
            const name = svg("text", { x: left - 8, y: y + pitch / 2 + 4, "text-anchor": "end",
                "font-weight": bar.total ? "bold" : "normal" });
            const letters = Math.floor((left - 10) / 6.6);
            name.textContent = bar.name.length > letters ? bar.name.slice(0, letters - 1) + "…" : bar.name;
            const value = svg("text", { x: closes ? at(a) - 6 : at(b) + 6, y: y + pitch / 2 + 4,
                "text-anchor": closes ? "end" : "start", "font-weight": bar.total ? "bold" : "normal" });
            value.textContent = fixed(bar.value, Math.abs(bar.value) < 1 ? 2 : 1, true);
            drawing.append(name, value);
        });
        return drawing;
    };
    return figure(id, title, text, draw, note ? make("p", { class: "note" }, note) : null);
}

/** Bars side by side over whole numbers, one group per number: how strong each multiple of the crank speed is. */
function orderChart({ id, title, text, unit, series }) {
    const draw = (width) => {
        const bars = series.flatMap((list, i) => list.values.map((value, k) => {
            const slot = 0.8 / series.length;
            return { x1: k - 0.4 + slot * i, x2: k - 0.4 + slot * (i + 1) - 0.03, y: value, i };
        }));
        return [Libraries.plot({ width, height: Math.max(220, width * 0.36), marginLeft: 56, marginBottom: 42, marginTop: 26,
            ariaLabel: title, style: { fontSize: "12px", background: "transparent" },
            x: { label: "multiple of the crank speed", labelAnchor: "right", labelArrow: "none", tickFormat: (k) => shown(k),
                ticks: series[0].values.map((_, k) => k) },
            y: { label: unit, labelArrow: "none", grid: true },
            marks: series.map((list, i) => Libraries.rectY(bars.filter((bar) => bar.i === i), { x1: "x1", x2: "x2", y: "y",
                fill: i % 2 ? "white" : style(i).colour, stroke: style(i).colour, strokeWidth: 1.4,
                strokeDasharray: i > 1 ? "3 2" : undefined })).concat(Libraries.ruleY([0])) }),
        make("ul", { class: "legend" }, series.map((list, i) => make("li", {}, svgBox(i), " ", list.name)))];
    };
    return figure(id, title, text, draw);
}

function svgBox(i) {
    return svg("svg", { width: 14, height: 12, "aria-hidden": "true" }, svg("rect", { x: 1, y: 1, width: 12, height: 10,
        fill: i % 2 ? "white" : style(i).colour, stroke: style(i).colour, "stroke-width": 1.4,
        "stroke-dasharray": i > 1 ? "3 2" : "" }));
}

/**
 * Horizontal bars, each { name, value, low, high, inner, said }: with a whisker from low to high if both are given, and a
 * narrow dark bar to inner. `said` is the text behind a bar, `reach` the least end of the axis.
 */
function barChart({ id, title, text, axis, bars, note, reach = 0 }) {
    const draw = (width) => {
        const longest = Math.max(...bars.map((bar) => bar.name.length));
        const left = Math.min(10 + 7 * longest, width * 0.42), right = 60, top = 6, bottom = 40, pitch = 24;
        const height = top + bottom + pitch * bars.length;
        const most = Math.max(...bars.flatMap((bar) => [bar.high ?? 0, bar.value ?? 0]), reach) || 1;
        const ticks = niceTicks(0, most, Math.max(3, Math.round((width - left) / 90))).filter((tick) => tick <= most * 1.001);
        const at = (value) => left + Math.max(0, value) / most * (width - left - right);
        const drawing = svg("svg", { width, height, viewBox: `0 0 ${width} ${height}`, role: "img", class: "plain",
            "aria-label": `${title}: ${bars.map((bar) => `${bar.name} ${bar.said}`).join(", ")}, ${axis}` });
        const write = (x, y, anchor, value, attributes = {}) => {
            const text = svg("text", { x, y, "text-anchor": anchor, ...attributes });
            text.textContent = value;
            drawing.append(text);
        };
        for (const tick of ticks) {
            drawing.append(svg("line", { x1: at(tick), x2: at(tick), y1: top, y2: height - bottom, stroke: tick === 0 ? "#8a8a8a" : "#e3e3e3" }));
            write(at(tick), height - bottom + 17, "middle", shown(tick, 3), { class: "tick" });
        }
        write(width - right, height - 6, "end", axis);
        bars.forEach((bar, i) => {
            const y = top + pitch * i, middle = y + pitch / 2;
            const { value, low, high } = bar, banded = Number.isFinite(low) && Number.isFinite(high);
            drawing.append(svg("rect", { x: at(0), y: y + 4, width: Math.max(1, at(value) - at(0)), height: pitch - 8, class: "bar",
                fill: "#9ecae8", stroke: "#0072b2" }));
            if (Number.isFinite(bar.inner)) drawing.append(svg("rect", { x: at(0), y: y + 9, width: Math.max(0, at(Math.min(bar.inner, most)) - at(0)),
                height: pitch - 18, fill: "#0072b2" }));
            for (const [x1, x2, y1, y2] of !banded ? [] : [[at(low), at(high), middle, middle], [at(low), at(low), middle - 4, middle + 4],
                [at(high), at(high), middle - 4, middle + 4]]) drawing.append(svg("line", { x1, x2, y1, y2, stroke: "#222222", "stroke-width": 1.4 }));
            const letters = Math.floor((left - 10) / 6.6);
            write(left - 8, middle + 4, "end", bar.name.length > letters ? `${bar.name.slice(0, letters - 1)}…` : bar.name);
            write(Math.max(at(value), banded ? at(high) : 0) + 6, middle + 4, "start", bar.said);
        });
        return drawing;
    };
    return figure(id, title, text, draw, note ? make("p", { class: "note" }, note) : null);
}

/** A table; the first cell of each row is its heading. */
function table(titles, rows, caption = null) {
    return make("div", { class: "wide" }, make("table", {}, caption ? make("caption", {}, caption) : null,
        make("thead", {}, make("tr", {}, titles.map((title) => make("th", { scope: "col" }, title)))),
        make("tbody", {}, rows.map((row) => make("tr", {}, row.map((cell, i) => make(i ? "td" : "th",
            i ? {} : { scope: "row" }, cell ?? "")))))));
}
