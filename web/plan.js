// The page of a planned calibration: what the planned runs will determine, and which further measurement would help most.

const { plan } = data;
const main = document.getElementById("page");
const percent = (share) => `${fixed(100 * share, 0)} %`;
const unitName = (unit) => (unit === "um" ? "µm" : unit || "factor");
const range = (parameter, low, high) => `${shown(parameter[low], 3)} to ${shown(parameter[high], 3)}`;

function conclusionsSection() {
    return make("section", { id: "conclusions" }, make("h2", {}, "What the plan can tell"),
        make("ul", {}, plan.conclusions.map((text) => make("li", {}, text))));
}

function unknownsSection() {
    const left = (parameter) => Math.sqrt(Math.max(0, 1 - parameter.shrinkage));
    return make("section", { id: "unknowns" }, make("h2", {}, "Unknowns"),
        barChart({ id: "left", title: "Uncertainty that will be left",
            text: "Standard deviation after the planned runs, as a share of that before. A bar near 100 % is an unknown that they cannot determine.",
            axis: "share of the standard deviation before [%]", reach: 100,
            bars: plan.parameters.map((one) => ({ name: one.name, value: 100 * left(one), said: percent(left(one)) })) }),
        make("p", {}, `Intervals hold the true value with a probability of ${percent(plan.level)}, if the model is right and the unknowns are near the `
            + "case's values. The last column says which share of the uncertainty (variance) the data will remove."),
        table(["unknown", "unit", "known before to", "then to", "by the data"], plan.parameters.map((one) => [one.name, unitName(one.unit),
            range(one, "prior_lower", "prior_upper"), range(one, "lower", "upper"), percent(one.shrinkage)])));
}

function candidatesSection() {
    if (!plan.candidates.length) return null;
    return make("section", { id: "candidates" }, make("h2", {}, "What would help most"),
        barChart({ id: "gains", title: "Information of a further measurement", text: "0.69 nat halve the volume of what is possible.", axis: "information [nat]",
            bars: plan.candidates.map((one) => ({ name: one.name, value: one.information_nat, said: shown(one.information_nat, 3) })) }),
        table(["candidate", "information [nat]", "tells most about", "its standard deviation falls to"], plan.candidates.map((one) => [one.name,
            shown(one.information_nat, 3), one.most_about, percent(one.deviation_after / one.deviation_before)])));
}

function combinationsSection() {
    return make("section", { id: "combinations" }, make("h2", {}, "Combinations that the plan determines"),
        make("p", {}, "× multiplies factors, / divides them. Where the singular value is above 1, the data will say more than was known before; "
            + "below 1 the values will stay those that were assumed."),
        table(["combination", "singular value", ""], plan.combinations.map((entry) => [entry.words.replaceAll(" x ", " × "),
            shown(entry.singular_value, 3), entry.known])));
}

function trustSection() {
    const list = (texts, attributes = {}) => make("ul", attributes, texts.map((text) => make("li", {}, text)));
    return make("section", { id: "trust" }, make("h2", {}, "Warnings and assumptions"),
        plan.warnings.length ? list(plan.warnings, { class: "warnings" }) : make("p", {}, "The plan gave no warnings."),
        plan.notes.length ? list(plan.notes) : null,
        make("p", {}, `${plan.runs} run${plan.runs === 1 ? "" : "s"} with ${plan.values} values, by derivatives of the reduced model ${plan.reduced_model} at the `
            + "values of the case."));
}

function startPlan() {
    const sections = [conclusionsSection(), unknownsSection(), candidatesSection(), combinationsSection(), trustSection()].filter(Boolean);
    const contents = make("nav", { "aria-label": "Sections" }, make("ul", {}, sections.map((section) => make("li", {},
        make("a", { href: `#${section.id}` }, section.querySelector("h2").textContent)))));
    main.prepend(make("a", { class: "skip", href: "#conclusions" }, "Skip to the results"));
    main.querySelector("h1").after(make("p", { class: "quiet" }, `Plan of a calibration of ${plan.case.name}, case ${plan.case.hash}, deadpoint ${plan.version}`),
        contents, plan.calibration.note ? make("p", {}, plan.calibration.note) : "");
    main.append(...sections);
    redrawFigures();
    document.body.dataset.ready = "true";
}
startPlan();
