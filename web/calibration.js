// The page of a calibration: what the data determine, measured curves beside the model before and after, profiles.

const calibration = data.calibration;
const main = document.getElementById("page");
const percent = (share) => `${fixed(100 * share, 0)} %`;
const unitName = (unit) => (unit === "um" ? "µm" : unit || "factor");
const quantityName = (name) => (name in data.schema.dimensions ? name : words(name));
const figureOf = (parameter, key) => shown(parameter[key], 3);

function conclusionsSection() {
    return make("section", { id: "conclusions" }, make("h2", {}, "What the data say"),
        make("ul", {}, calibration.conclusions.map((text) => make("li", {}, text))));
}

function intervalOf(parameter) {
    return `${parameter.open_below ? "below " : ""}${figureOf(parameter, "lower")} to ${parameter.open_above ? "above " : ""}`
        + figureOf(parameter, "upper");
}

function parametersSection() {
    const rows = calibration.parameters.map((parameter) => [parameter.name, figureOf(parameter, "estimate"), unitName(parameter.unit),
        intervalOf(parameter), `${figureOf(parameter, "prior_lower")} to ${figureOf(parameter, "prior_upper")}`,
        percent(parameter.shrinkage), parameter.known]);
    const keys = calibration.parameters.flatMap((parameter) => parameter.keys.map((value) => [value.key, value.before, value.after]));
    return make("section", { id: "unknowns" }, make("h2", {}, "Unknowns"),
        make("p", {}, `Intervals hold the true value with a probability of ${percent(calibration.level)}, if the model is right. The last `
            + "columns say which share of the uncertainty before (variance) the data removed, and what that tells."
            + (calibration.model.differs ? " The model does not explain these data, so that no unknown is known by them." : "")),
        make("div", { class: "wide" }, table(["unknown", "value", "unit", "interval", "before", "removed", "known"], rows)),
        make("details", {}, make("summary", {}, "Values of the case"), make("div", { class: "wide" },
            table(["key", "before", "calibrated"], keys))));
}

function combinationsSection() {
    return make("section", { id: "combinations" }, make("h2", {},
        calibration.model.differs ? "Combinations that the data would determine if the model were right" : "Combinations that the data determine"),
        make("p", {}, "× multiplies factors, / divides them. Where the singular value is above 1, the data say more than was known before; "
            + "below 1 the values are those that were assumed."),
        table(["combination", "singular value", ""], calibration.combinations.map((entry) => [entry.words.replaceAll(" x ", " × "),
            shown(entry.singular_value, 3), entry.known])));
}

function skillSection() {
    const number = (value) => (value === null ? "–" : shown(value, 3));
    return make("section", { id: "skill" }, make("h2", {}, "Errors of fitted and held-out runs"),
        make("p", {}, "Root mean square errors of the calibrated case, beside three predictions without it: the case as it was, the value "
            + "at the start, and the mean of the other fitted runs."),
        make("div", { class: "wide" }, table(["run", "quantity", "", "values", "unit", "calibrated", "case as it was", "no change",
            "mean of runs", "in the band", "model error"], calibration.curves.map((curve) => [curve.run, curve.quantity,
            curve.held_out ? "held out" : "fitted", String(curve.values), unitName(curve.unit), number(curve.rms),
            number(curve.rms_of_case), number(curve.rms_of_no_change), number(curve.rms_of_mean), percent(curve.inside_band),
            number(curve.model_error)]))));
}

function chartOf(course, curve, i) {
    const x = course.hours;
    const line = (name, y, style, more = {}) => ({ name, x, y, style, ...more });
    return lineChart({ id: `${course.run}-${curve.quantity}`, title: `${quantityName(curve.quantity)} in ${course.run}`,
        text: `${course.held_out ? "Held out: predicted, not fitted. " : ""}The band holds the true value with a probability of `
            + `${percent(calibration.level)}.`, x: ["time", "h"], y: [curve.unit === "µm" ? "change" : "temperature", curve.unit],
        zero: curve.unit === "µm", markNote: curve.measured.length ? "measured" : "", series: [
            line("calibrated", curve.value, 0, { bold: true, marks: curve.measured }),
            line("lower", curve.lower, 4), line("upper", curve.upper, 4), line("as it was", curve.before, 1)] });
}

function runSection(course, number) {
    const order = (curve) => (curve.measured.length ? 0 : curve.quantity === gapName ? 1 : 2);
    const curves = course.curves.filter((curve) => order(curve) < 2).sort((a, b) => order(a) - order(b));
    const others = course.curves.filter((curve) => order(curve) === 2);
    return make("section", { id: `run-${number}` }, make("h2", {}, `Run: ${words(course.run)}${course.held_out ? " (held out)" : ""}`),
        curves.map((curve, i) => chartOf(course, curve, i)).filter(Boolean),
        others.length ? make("details", {}, make("summary", {}, "Quantities that were not measured"),
            others.map((curve, i) => chartOf(course, curve, i)).filter(Boolean)) : null);
}

function profilesSection() {
    const charts = calibration.parameters.filter((parameter) => parameter.profile.values.length > 2).map((parameter) =>
        lineChart({ id: `profile-${parameter.name}`, title: parameter.name, text: null, x: ["value", unitName(parameter.unit)],
            y: ["rise of twice the cost", "–"], dots: true, series: [{ name: parameter.name, x: parameter.profile.values,
                y: parameter.profile.rise }] }));
    if (!charts.length) return null;
    return make("section", { id: "profiles" }, make("h2", {}, "Profiles"),
        make("p", {}, "Each value is held in turn, and all others are fitted again. A flat line means that the data do not determine the value."),
        make("details", {}, make("summary", {}, `${charts.length} charts`), charts));
}

function trustSection() {
    const { warnings, notes, model, fit } = calibration;
    return make("section", { id: "trust" }, make("h2", {}, "Warnings and accuracy"),
        warnings.length ? make("ul", { class: "warnings" }, warnings.map((text) => make("li", {}, text)))
            : make("p", {}, "The calibration gave no warnings."),
        notes.length ? make("ul", {}, notes.map((text) => make("li", {}, text))) : null,
        make("p", {}, `The reduced model states an error of ${shown(model.reduced_error_K, 2)} K and ${shown(model.reduced_error_um, 2)} µm; half `
            + `of it counts as noise. Its time steps change the fit by ${shown(model.step_error_K, 2)} K and ${shown(model.step_error_um, 2)} µm. `
            + `${fit.starts} starting points, ${fit.model_runs} runs of the model with derivatives, ${duration(fit.seconds)}.`),
        make("p", {}, calibration.full_run ? `A full run of the calibrated case differs by at most ${shown(calibration.full_run.difference_K, 2)} K and `
            + `${shown(calibration.full_run.difference_um, 2)} µm.` : "No full run checked the calibrated case (--full-run)."));
}

function startCalibration() {
    const sections = [conclusionsSection(), parametersSection(), skillSection(), ...data.courses.map(runSection), combinationsSection(),
        profilesSection(), trustSection()].filter(Boolean);
    const contents = make("nav", { "aria-label": "Sections" }, make("ul", {}, sections.map((section) => make("li", {},
        make("a", { href: `#${section.id}` }, section.querySelector("h2").textContent)))));
    main.prepend(make("a", { class: "skip", href: "#conclusions" }, "Skip to the results"));
    main.querySelector("h1").after(make("p", { class: "quiet" }, `Calibration of ${calibration.case.name}, case ${calibration.case.hash}, deadpoint `
        + calibration.version), contents, calibration.calibration.note ? make("p", {}, calibration.calibration.note) : "");
    main.append(...sections);
    main.querySelectorAll("details").forEach((element) => element.addEventListener("toggle", () => redrawFigures()));
    redrawFigures();
    document.body.dataset.ready = "true";
}
startCalibration();
