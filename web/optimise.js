// The page of a search for an optimum: what changed, what it gives, and whether a full run confirms it.

const optimise = data.optimise;
const main = document.getElementById("page");
const courses = parseCsv(data.courses, "courses.csv");
const { study: origin, before, promised, full_run: full, variables } = optimise;
const unitText = (unit) => unit.replace("um", "µm");
const objectives = { drift: "least change of the gap", "warm-up": "shortest warm-up", ambient: "least effect of the room" };
const hours = (value) => (value === null ? "not reached" : duration(value * 3600));
const designs = ["before", "optimum", "full run"].filter((name) => column(courses, "gap_of_design", name));
const designNames = { before: "before", optimum: "optimum", "full run": "optimum, full run" };

function courseChart(id, title, text, kind, y, least, most = Infinity) {
    const time = column(courses, "time");
    const from = [...time].findIndex((value) => value >= least);
    return lineChart({ id, title, text, x: ["time", "h"], y, series: designs.map((name, i) => ({ name: designNames[name], style: i, bold: name === "optimum",
        x: [...time].slice(from).map((value) => value / 3600), y: [...column(courses, kind, name)].slice(from).map((value) => (Math.abs(value) > most ? NaN : value)) })) });
}

/** The speeds of the profile as steps, and the speed behind it. */
function profileChart() {
    const ends = optimise.profile_ends_s;
    if (!ends) return null;
    const speeds = (kind) => variables.slice(0, ends.length).map((variable) => variable[kind]);
    const steps = (kind) => ends.flatMap((end, i) => [{ x: (i ? ends[i - 1] : 0) / 3600, y: speeds(kind)[i] }, { x: end / 3600, y: speeds(kind)[i] }]);
    return lineChart({ id: "profile", title: "Speed over time", text: "Behind the last interval the press keeps its own speed.", x: ["time", "h"],
        y: ["speed", variables[0].unit], series: ["before", "optimum"].map((kind, i) => ({ name: kind, style: i, bold: kind === "optimum",
            x: steps(kind).map((point) => point.x), y: steps(kind).map((point) => point.y) })) });
}

function figuresSection() {
    const all = [before, promised, ...(full ? [full] : [])];
    const row = (name, of) => [name, ...all.map(of)];
    const since = optimise.from_s > 0 ? ` since ${duration(optimise.from_s)}` : "";
    const rows = [...(optimise.rate_um_per_h > 0 ? [row(`warm (below ${shown(optimise.rate_um_per_h)} µm/h) after`, (f) => hours(f.warm_after_h))] : []),
        row(`change of E_SW${since}, root mean square [µm]`, (f) => fixed(f.drift_rms_um, 2)),
        row(`change of E_SW${since}, largest [µm]`, (f) => fixed(f.largest_change_um, 2)),
        ...(promised.ambient_um_per_K !== null ? [row("E_SW per kelvin of the room, root mean square [µm/K]", (f) => fixed(f.ambient_um_per_K, 3))] : []),
        ...optimise.limits.map((limit, l) => row(`${limit.output}: ${[limit.most && `at most ${limit.most}`, limit.least && `at least ${limit.least}`]
            .filter(Boolean).join(", ")}`, (f) => fixed(f.limits[l], 2)))];
    return make("section", { id: "figures" }, make("h2", {}, "What it gives"),
        table(["", "before", "promised by the reduced model", ...(full ? ["full run"] : [])], rows),
        full ? null : make("p", {}, "The optimum was not run in full: “deadpoint run optimum.toml” does so."));
}

function coursesSection() {
    return make("section", { id: "courses" }, make("h2", {}, "The gap over time"),
        courseChart("gap", "Change of the gap E_SW", "Above zero the gap opens.", "gap_of_design", ["change", "µm"], 0),
        courseChart("rate", "Rate of the gap", optimise.rate_um_per_h > 0 ? `Rates of more than ten times the limit of ${shown(optimise.rate_um_per_h)} µm/h are left out.`
            : "", "rate_of_design", ["rate", "µm/h"], 0, optimise.rate_um_per_h > 0 ? 10 * optimise.rate_um_per_h : Infinity), profileChart());
}

function variablesSection() {
    return make("section", { id: "variables" }, make("h2", {}, "Variables"), table(["variable", "before", "optimum", "unit", "range"],
        variables.map((one) => [words(one.name), shown(one.before, 4), shown(one.optimum, 4), one.unit || "–", one.range])));
}

function startsSection() {
    return make("section", { id: "starts" }, make("h2", {}, "Starts"),
        make("p", {}, optimise.starts.length === 1 ? "There was one start only; another one may end elsewhere."
            : `The best of ${optimise.starts.length} starts is number ${optimise.best_start}; ${optimise.minima === 1
                ? "all end at the same minimum." : `they end at ${optimise.minima} different minima.`}`),
        table(["start", `objective [${unitText(optimise.unit)}]`, "keeps limits", "evaluations", "end", "variables"], optimise.starts.map((one, i) =>
            [i === 0 ? "1 (the case)" : String(i + 1), shown(one.value, 4), one.keeps_limits ? "yes" : "no", String(one.evaluations), one.end,
                one.to.map((value) => shown(value, 4)).join(", ")])));
}

function trustSection() {
    return make("section", { id: "trust" }, make("h2", {}, "Warnings and assumptions"),
        optimise.keeps_limits ? null : make("p", {}, "No point keeps all limits; this one exceeds them least."),
        optimise.warnings.length ? make("ul", { class: "warnings" }, optimise.warnings.map((text) => make("li", {}, text)))
            : make("p", {}, "The search gave no warnings."));
}

function aboutSection() {
    return make("section", { id: "about" }, make("h2", {}, "How to repeat this"),
        table(["", ""], [["study", origin.name], ["base case", origin.base.replace(/^.*\//, "")],
            ["changed in all runs", origin.overrides.join(", ") || "nothing"], ["objective", objectives[optimise.objective]],
            ["method", optimise.method], ["reduced model", optimise.reduced_model], ["case hash", optimise.case.hash],
            ["computed with", `deadpoint ${optimise.version}`], ["computing time", duration(optimise.seconds)]]));
}

function lead() {
    const value = (figures) => ({ drift: `${fixed(figures.drift_rms_um, 2)} µm`, "warm-up": hours(figures.warm_after_h),
        ambient: `${fixed(figures.ambient_um_per_K, 3)} µm/K` })[optimise.objective];
    return make("p", { class: "lead" }, `The ${objectives[optimise.objective]}: ${value(promised)} instead of ${value(before)}`
        + (full && optimise.objective !== "ambient" ? `; the full run gives ${value(full)}.` : "."));
}

function startOptimum() {
    const contents = make("nav", { "aria-label": "Sections" });
    const sections = [figuresSection(), coursesSection(), variablesSection(), startsSection(), trustSection(), aboutSection()];
    main.prepend(make("a", { class: "skip", href: "#figures" }, "Skip to the results"));
    main.querySelector("h1").after(make("p", { class: "quiet" }, `A search for an optimum, deadpoint ${optimise.version}, machine ${optimise.case.name}`),
        contents, origin.note ? make("p", {}, origin.note) : "", lead());
    main.append(...sections);
    contents.replaceChildren(make("ul", {}, sections.map((section) => make("li", {}, make("a", { href: `#${section.id}` },
        section.querySelector("h2").textContent)))));
    redrawFigures();
    document.body.dataset.ready = "true";
}
startOptimum();
