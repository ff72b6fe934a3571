// What follows the gap: how parallel the slide stays, and the clearances of bearings and guides.

const gapHours = (run) => column(run.gaps, "time").map((second) => second / 3600);

/** Columns of gaps.csv of a kind, as lines. */
function gapLines(run, kind) {
    const x = gapHours(run);
    return columnsOf(run.gaps, kind).map((entry) => ({ name: words(entry.of), x, y: entry.values }));
}

/** The corners as they lie, seen from above with the front below. */
function cornerPlan(corners, caption, pick) {
    const cell = (name) => (corners[name] ? fixed(pick(corners[name]), 1, true) : "–");
    return table(["", "left", "right"], [["back", cell("back left"), cell("back right")],
        ["front", cell("front left"), cell("front right")]], caption);
}

function parallelSection(run) {
    const parallel = run.summary?.gaps?.parallelism;
    if (!parallel || !run.gaps) return null;
    const half = run.summary.model?.half_model;
    const sideways = half && parallel.left_to_right.largest_um_per_m === 0;
    const corners = gapLines(run, "corner_gap").filter((line) => !sideways || line.name.endsWith("left"))
        .map((line) => (sideways ? { ...line, name: line.name.replace(" left", ", both sides") } : line));
    const gap = column(run.history, "dimension", gapName);
    const slopes = [["slope_left_to_right", "left to right"], ["slope_front_to_back", "front to back"]].slice(sideways ? 1 : 0)
        .map(([kind, name]) => ({ name, x: gapHours(run), y: column(run.gaps, kind) }));
    const [across, along] = [parallel.left_to_right, parallel.front_to_back];
    const steepest = Math.abs(across.largest_um_per_m) > Math.abs(along.largest_um_per_m)
        ? ["to the right", "to the left", across] : ["at the back", "in front", along];
    return make("section", { id: "parallelism" }, make("h2", {}, "Slide parallelism"),
        make("p", {}, "Changes of the gap at the four corners of the slide since the start, at bottom dead point and unloaded. "
            + (parallel.directions ? `As the operator sees it: ${parallel.directions}. ` : "")
            + (sideways ? "Half of the press is computed, so left and right are mirror images and there is no slope between them. " : "")
            + `The slope is steepest after ${duration(steepest[2].time_of_largest_s)}: the gap is wider `
            + `${steepest[2].largest_um_per_m > 0 ? steepest[0] : steepest[1]} by `
            + `${fixed(Math.abs(steepest[2].largest_um_per_m), 1)} µm per metre.`),
        lineChart({ id: "corners", title: "Gap at the corners of the slide", text: "E_SW is the mean over the whole "
            + "face; the corners differ from it where the face bends.", x: ["time", "h"], y: ["change", "µm"],
            series: [...corners, ...(gap ? [{ name: "E_SW, mean", x: run.hours, y: gap, bold: true }] : [])] }),
        lineChart({ id: "slopes", title: "Slope of the slide against the table", text: "Positive if the gap opens more to the "
            + "right, or to the back.", x: ["time", "h"], y: ["slope", "µm/m"], series: slopes }),
        cornerPlan(parallel.corners, "Change at the end [µm], seen from above", (corner) => corner.final_um),
        make("p", { class: "note" }, "The surfaces of the joints determine the tilt of the slide: the tilts of all bodies are "
            + "those with the least mismatch in pins, bearings and guides. Play and compliance of joints are left out."));
}

function clearanceSection(run) {
    const list = run.summary?.gaps?.clearances;
    if (!list || !run.gaps) return null;
    const stated = list.some((entry) => "initial_um" in entry);
    const rows = [...list].sort((a, b) => a.least_change_um - b.least_change_um).map((entry) => [words(entry.name),
        entry.kind === "guide" ? "guide, both faces" : "bearing, diameter", fixed(entry.final_change_um, 1, true),
        fixed(entry.least_change_um, 1, true), entry.least_change_um < -0.05 ? duration(entry.time_of_least_s) : "–",
        ...(stated ? [shown(entry.initial_um), "initial_um" in entry ? fixed(entry.least_um, 1) : "–",
            !("initial_um" in entry) ? "–" : entry.used_up_s === null ? "open"
                : `used up after ${duration(entry.used_up_s)}`] : [])]);
    const lines = strongest(gapLines(run, "clearance"), 8);
    return make("section", { id: "clearances" }, make("h2", {}, "Clearances"),
        make("p", {}, "Changes since the start; below zero the clearance closes. For bearings and pins the clearance is that of the diameter and "
            + "includes the growth of their rings; for guides it is the sum over both faces. "
            + (stated ? "" : "The case states no clearances at the start, so the remaining clearance is not known "
                + "(joints.NAME.clearance).")),
        lineChart({ id: "clearance-changes", title: "Change of the clearances", text: lines.length < list.length
            ? `The eight of ${list.length} that change most.` : "", x: ["time", "h"], y: ["change", "µm"], series: lines }),
        table(["", "of", "at the end [µm]", "closes most [µm]", "after",
            ...(stated ? ["at the start [µm]", "least left [µm]", "state"] : [])], rows),
        run.summary.gaps.left_out?.length ? make("p", { class: "note" }, `Not followed: ${run.summary.gaps.left_out.join("; ")}.`)
            : null);
}

function forceChart(run) {
    const force = run.summary?.gaps?.force;
    if (!force || !run.gaps) return null;
    return lineChart({ id: "force-change", title: "Force at a fixed die height", text: "Change of the force if the die height is "
        + `never readjusted: the change of the gap times the stiffness of press and tool, ${shown(force.press_stiffness_N_per_m / 1e9)} kN/µm.`,
    x: ["time", "h"], y: ["change of the force", "kN"], series: [{ name: "force", x: gapHours(run),
        y: column(run.gaps, "force_change") }] });
}
