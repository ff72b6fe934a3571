// The page of a study of sensitivity: which parameters matter for which output, and when.

const sensitivity = data.sensitivity;
const { study: origin } = sensitivity;
const main = document.getElementById("page");
const screening = sensitivity.method === "morris";
const outputs = [...new Set(sensitivity.figures.map((entry) => entry.output))];
const names = sensitivity.parameters.map((parameter) => parameter.name);
const label = (name) => (name in data.schema.dimensions ? name : words(name));
const unitText = (unit) => unit.replace("um", "µm");
const mostBars = 20, mostCurves = 7;

const figureTitle = (entry) => (entry.figure === "time to warm" ? `${label(entry.output)}: time to warm (95 % of the change)`
    : `${label(entry.output)} ${entry.figure === "end" ? "at the end" : `after ${entry.figure}`}`);
const bandOf = (entry, name) => entry.parameters[name][screening ? "strength" : "total"];
const sized = (value) => (Number.isFinite(value) ? value : -1);
const ranked = (entry) => [...names].sort((a, b) => sized(bandOf(entry, b)[0]) - sized(bandOf(entry, a)[0]));
const varies = (entry) => names.some((name) => bandOf(entry, name)[0] !== null);

/** What a bar of an entry shows: the wide bar with its band, and a narrow one within. */
function barOf(entry, name) {
    const values = entry.parameters[name];
    const [value, low, high] = bandOf(entry, name);
    return { name: words(name), value, low, high, inner: screening ? Math.abs(values.mean) : Math.max(0, values.first[0]),
        said: screening ? shown(value, 3) : fixed(value, 2) };
}

function figureBars(entry, number) {
    const title = figureTitle(entry);
    if (!varies(entry)) return make("p", {}, `${title} does not vary within the ranges.`);
    const order = ranked(entry).slice(0, mostBars);
    const spread = screening ? "" : `${shown(entry.mean, 4)} ${unitText(entry.mean_unit)} on average, standard deviation ${shown(entry.deviation)} ${unitText(entry.unit)}.`;
    return barChart({ id: `bars-${entry.output}-${number}`, title, text: spread, bars: order.map((name) => barOf(entry, name)),
        axis: screening ? `mean size of the effect [${unitText(entry.unit)}]` : "share of the variance", reach: screening ? 0 : 0.2,
        note: order.length < names.length ? `The ${names.length - order.length} weakest of ${names.length} parameters are left out.` : null });
}

/** Curves of the strongest parameters of an output over time. */
function overTime(output) {
    const course = sensitivity.course.find((entry) => entry.output === output);
    if (!course) return null;
    const kind = screening ? "strength" : "total";
    const peak = (name) => Math.max(...course.parameters[name][kind].map((value) => value ?? 0));
    const order = [...names].sort((a, b) => peak(b) - peak(a)).slice(0, mostCurves);
    const what = screening ? "Mean size of the effects" : "Total indices";
    const curves = [lineChart({ id: `course-${output}`, title: `${what} over time: ${label(output)}`,
        text: order.length < names.length ? `The ${order.length} strongest of ${names.length} parameters.` : "", x: ["time", "h"],
        y: screening ? ["mu*", unitText(course.unit)] : ["total index", "–"],
        series: order.map((name, i) => ({ name: words(name), style: i, x: course.hours, y: course.parameters[name][kind].map((value) => value ?? NaN) })) })];
    if (course.deviation) curves.push(lineChart({ id: `deviation-${output}`, title: `Standard deviation over time: ${label(output)}`,
        text: "How far the runs lie apart; where it is small, shares of it matter little.", x: ["time", "h"], y: ["deviation", unitText(course.unit)],
        series: [{ name: label(output), bold: true, x: course.hours, y: course.deviation.map((value) => value ?? NaN) }] }));
    return curves;
}

function outputSection() {
    const body = make("div");
    let chosen = Math.max(0, outputs.indexOf(gapName));
    const draw = () => {
        const own = sensitivity.figures.filter((entry) => entry.output === outputs[chosen]);
        body.replaceChildren(...[...own.map(figureBars), ...(overTime(outputs[chosen]) ?? [])].filter(Boolean));
        redrawFigures();
    };
    const choose = make("select", { "data-control": "output", change: () => { chosen = choose.selectedIndex; draw(); } },
        outputs.map((name) => make("option", {}, label(name))));
    choose.selectedIndex = chosen;
    draw();
    return make("section", { id: "outputs" }, make("h2", {}, "What matters for an output"),
        make("p", {}, screening
            ? "A bar is mu*, the mean size of the change of the figure when the parameter runs over its whole range; the dark bar is the size of mu, "
            + "the mean with its sign. Where both differ, the sign of the effect changes. The line is the band of 90 %."
            : "A bar is the total index: the share of the variance that would remain if all other parameters were known. The dark bar is the index of "
            + "first order, the share that the parameter explains alone; the rest of the bar is interaction. The line is the band of 90 %."),
        make("div", { class: "controls" }, make("label", {}, "Output", choose)), body);
}

function matrixSection() {
    const ends = sensitivity.figures.filter((entry) => entry.figure === "end" && varies(entry));
    if (ends.length < 2) return null;
    const largest = Object.fromEntries(ends.map((entry) => [entry.output, Math.max(...names.map((name) => bandOf(entry, name)[0] ?? 0))]));
    const order = [...names].sort((a, b) => Math.max(...ends.map((entry) => (bandOf(entry, b)[0] ?? 0) / largest[entry.output]))
        - Math.max(...ends.map((entry) => (bandOf(entry, a)[0] ?? 0) / largest[entry.output])));
    const cell = (entry, name) => {
        const value = bandOf(entry, name)[0];
        const share = (value ?? 0) / largest[entry.output];
        const element = make("td", {}, screening ? shown(value, 3) : fixed(value, 2));
        element.style.background = `rgb(${[235, 243, 250].map((light, c) => Math.round(light + share * ([8, 72, 122][c] - light))).join()})`;
        element.style.color = share > 0.45 ? "white" : "inherit";
        return element;
    };
    return make("section", { id: "matrix" }, make("h2", {}, "All outputs at the end"),
        make("p", {}, `${screening ? "Mean size of the effect (mu*)" : "Total index"} of each parameter; darker is stronger within its column.`),
        make("div", { class: "wide" }, make("table", { class: "map" },
            make("thead", {}, make("tr", {}, make("th", { scope: "col" }, "parameter"), ends.map((entry) =>
                make("th", { scope: "col" }, screening ? `${label(entry.output)} [${unitText(entry.unit)}]` : label(entry.output))))),
            make("tbody", {}, order.map((name) => make("tr", {}, make("th", { scope: "row" }, words(name)), ends.map((entry) => cell(entry, name))))))));
}

function parametersSection() {
    return make("section", { id: "parameters" }, make("h2", {}, "Parameters and their ranges"),
        table(["parameter", "range", "keys"], sensitivity.parameters.map((parameter) => [words(parameter.name), parameter.range, parameter.keys.join(", ")])));
}

function trustSection() {
    const share = sensitivity.failed / sensitivity.runs;
    return make("section", { id: "trust" }, make("h2", {}, "Warnings and assumptions"),
        sensitivity.warnings.length ? make("ul", { class: "warnings" }, sensitivity.warnings.map((text) => make("li", {}, text)))
            : make("p", {}, "The study gave no warnings."),
        sensitivity.failed ? make("p", {}, `${sensitivity.failed} runs (${fixed(100 * share, 1)} %) failed and are left out.`) : null,
        make("p", {}, "All parameters vary independently, each evenly over its range (factors evenly by their logarithm). The runs use the reduced model; its "
            + "error is far smaller than effects that matter here, if no coefficient leaves the range for which it was built."));
}

function aboutSection() {
    return make("section", { id: "about" }, make("h2", {}, "How to repeat this"),
        table(["", ""], [["study", origin.name], ["base case", origin.base.replace(/^.*\//, "")],
            ["changed in all runs", origin.overrides.join(", ") || "nothing"], ["method", screening ? "Morris screening" : "Sobol' indices"],
            [screening ? "trajectories" : "points", String(sensitivity.rows)], ["seed", String(sensitivity.seed)], ["runs", String(sensitivity.runs)],
            ["reduced model", sensitivity.reduced_model], ["case hash", sensitivity.case.hash], ["computed with", `deadpoint ${sensitivity.version}`],
            ["computing time", duration(sensitivity.seconds)]]));
}

function lead() {
    const entry = sensitivity.figures.find((one) => one.output === gapName && one.figure === "end") ?? sensitivity.figures[0];
    if (!varies(entry)) return "";
    const [first, second] = ranked(entry);
    const size = (name) => (screening ? `${shown(bandOf(entry, name)[0], 3)} ${unitText(entry.unit)}` : `${fixed(100 * bandOf(entry, name)[0], 0)} % of the variance`);
    return make("p", { class: "lead" }, `${figureTitle(entry)} depends most on ${words(first)} (${size(first)})`
        + (second ? `, then on ${words(second)} (${size(second)}).` : "."));
}

function startStudy() {
    const contents = make("nav", { "aria-label": "Sections" });
    const sections = [outputSection(), matrixSection(), parametersSection(), trustSection(), aboutSection()].filter(Boolean);
    main.prepend(make("a", { class: "skip", href: "#outputs" }, "Skip to the results"));
    main.querySelector("h1").after(make("p", { class: "quiet" }, `A study of sensitivity with ${names.length} parameters in ${sensitivity.runs} runs, deadpoint `
        + `${sensitivity.version}, machine ${sensitivity.case.name}`), contents, origin.note ? make("p", {}, origin.note) : "", lead());
    main.append(...sections);
    contents.replaceChildren(make("ul", {}, sections.map((section) => make("li", {}, make("a", { href: `#${section.id}` },
        section.querySelector("h2").textContent)))));
    redrawFigures();
    document.body.dataset.ready = "true";
}
startStudy();
