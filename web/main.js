// Puts the page together: several runs side by side first, then one run in full.

const page = document.getElementById("page");
const heading = page.querySelector("h1");

/** Patterns that keep areas apart without colour. */
function patterns() {
    const pattern = (id, size, ...shapes) => svg("pattern", { id, width: size, height: size, patternUnits: "userSpaceOnUse" },
        ...shapes);
    return svg("svg", { width: 0, height: 0, "aria-hidden": "true", style: "position:absolute" }, svg("defs", {},
        pattern("hatched", 7, svg("rect", { width: 7, height: 7, fill: "#fbe3d3" }), svg("path", { d: "M-1 8L8 -1M-1 1L1 -1M6 8L8 6",
            stroke: "#d55e00", "stroke-width": 1.8 })),
        pattern("dotted", 7, svg("rect", { width: 7, height: 7, fill: "#eef3f6" }), svg("circle", { cx: 3.5, cy: 3.5, r: 1.2,
            fill: "#5f7d90" })),
        pattern("crossed", 8, svg("rect", { width: 8, height: 8, fill: "#f4efe2" }), svg("path", { d: "M0 0L8 8M8 0L0 8",
            stroke: "#a08c55", "stroke-width": 0.9 }))));
}

/** Figures of all runs in one table, and the same curve of each over the others. */
function sideBySide() {
    const rows = [];
    const row = (title, of) => {
        const cells = runs.map((run) => { try { return of(run); } catch { return undefined; } });
        if (cells.some((cell) => cell !== undefined && cell !== null))
            rows.push([title, ...cells.map((cell) => cell ?? "–")]);
    };
    row("case", (run) => run.facts.case?.name);
    row("largest change of the gap [µm]", (run) => run.summary.drift_um && fixed(run.summary.drift_um.largest_E_SW, 1, true));
    row("change of the gap at the end [µm]", (run) => run.summary.drift_um && fixed(run.summary.drift_um.final_E_SW, 1, true));
    row("steady from", (run) => run.summary.warm_up_s && duration(run.summary.warm_up_s));
    const slope = (run, which) => fixed(run.summary.gaps.parallelism[which].final_um_per_m, 1, true);
    row("slope of the slide at the end, left to right [µm/m]", (run) => slope(run, "left_to_right"));
    row("slope of the slide at the end, front to back [µm/m]", (run) => slope(run, "front_to_back"));
    row("largest change of the force [kN]", (run) => fixed(run.summary.gaps.force.largest_kN, 1, true));
    row("heat of joints and heat sources [MJ]", (run) => shown(run.summary.energy_J.generated / 1e6));
    const probes = [...new Set(runs.flatMap((run) => Object.keys(run.summary?.probe_rises_K ?? {})))];
    for (const probe of probes) row(`rise of ${words(probe)} [K]`, (run) => fixed(run.summary.probe_rises_K[probe].end, 2, true));
    row("off the reference, rms [K]", (run) => run.summary.reference && shown(run.summary.reference.rms_residual_K));
    row("process force [kN]", (run) => shown(run.loads.operation.process_force_peak_N / 1000));
    row("speed [rpm]", (run) => shown(run.loads.operation.speed_rpm));
    row("mean drive power [kW]", (run) => fixed(run.loads.drive.mean_power_W / 1000, 2));
    row("warnings", (run) => String(run.facts.warnings?.length ?? 0));
    row("case hash", (run) => run.facts.case?.hash);
    const overlay = (id, title, kind, of, y) => lineChart({ id, title, x: ["time", "h"], y,
        zero: y[1] !== "°C", series: runs.map((run, i) => ({ name: run.name, x: run.hours, style: i, bold: false,
            y: column(run.history, kind, of) })) });
    // What most results have comes first.
    const counts = new Map();
    for (const entry of runs.flatMap((run) => run.history ?? []))
        if (entry.kind !== "time" && entry.of !== gapName) {
            const key = [entry.name, entry.unit, entry.kind, entry.of].join("\n");
            counts.set(key, (counts.get(key) ?? 0) + 1);
        }
    const others = [...counts].sort((a, b) => b[1] - a[1]).map(([key]) => key);
    const place = make("div");
    const choose = make("select", { "aria-label": "quantity to compare", "data-control": "compare", change: () => show() },
        others.map((entry) => make("option", { value: entry }, words(entry.split("\n")[0]))));
    const show = () => {
        const [name, unit, kind, of] = choose.value.split("\n");
        place.replaceChildren(overlay("compared", words(name), kind, of, ["value", unit.replace("degC", "°C").replace("um", "µm")])
            ?? "");
        redrawFigures();
    };
    const section = make("section", { id: "side-by-side" }, make("h2", {}, "Side by side"),
        table(["", ...runs.map((run) => run.name)], rows),
        overlay("compared-gap", "Change of the gap E_SW", "dimension", gapName, ["change", "µm"]));
    if (others.length) {
        section.append(make("div", { class: "controls" }, make("label", {}, "Compare", choose)), place);
        show();
    }
    return section;
}

let current = null;
const detail = make("div", { id: "detail" });
const contents = make("nav", { "aria-label": "Sections" });

function showRun(run) {
    current?.dispose();
    const stage = viewSection(run);
    const sections = [stage?.section, driftSection(run), sensitivitySection(run), parallelSection(run),
        clearanceSection(run), temperatureSection(run), heatSection(run), loadsSection(run),
        comparisonSection(run), trustSection(run), aboutSection(run)].filter(Boolean);
    detail.replaceChildren(make("div", {}, lead(run), facts(run)), ...sections);
    const listed = [document.getElementById("side-by-side"), ...sections].filter(Boolean);
    contents.replaceChildren(make("ul", {}, listed.map((section) => make("li", {}, make("a", { href: `#${section.id}` },
        section.querySelector("h2").textContent)))));
    stage?.start?.();
    redrawFigures();
    current = stage;
}

function start() {
    const first = runs[0];
    const source = first.facts;
    page.prepend(make("a", { class: "skip", href: "#detail" }, "Skip to the results"));
    page.append(patterns());
    heading.after(make("p", { class: "quiet" }, runs.length === 1
        ? `deadpoint ${source.version}, case hash ${source.case?.hash ?? "–"}, folder ${first.name}`
        : `${runs.length} results, put together by deadpoint ${data.version}`), contents);
    if (runs.length > 1) {
        page.append(sideBySide());
        const choose = make("select", { "aria-label": "result shown in full", "data-control": "run",
            change: () => showRun(runs[choose.selectedIndex]) }, runs.map((run) => make("option", {}, run.name)));
        page.append(make("div", { class: "controls" }, make("label", {}, make("strong", {}, "Shown in full below:"), choose)));
    }
    page.append(detail);
    showRun(first);
    const pose = location.hash.match(/^#picture=(\w+)$/);
    if (pose) current?.pose?.(pose[1]);
    document.body.dataset.ready = "true";
}
start();
