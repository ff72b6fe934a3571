// The sections of the page. Each is made from the data of one results folder, or is null if the folder has no such data.

const kelvinNote = "Rises are relative to the temperature at the start. Heat is that of the whole press.";

/** Heat is called friction heat where nothing else heats: no motor, no clutch, no enclosed power. */
const heatName = (run) => columnsOf(run.history, "source_heat", "enclosed_air_power").length
    ? "heat of joints and heat sources" : "friction heat";

function facts(run) {
    const { summary, loads } = run;
    const cards = [];
    const card = (label, value) => cards.push(make("li", {}, make("span", { class: "value" }, value),
        make("span", { class: "label" }, label)));
    if (summary?.drift_um) {
        const drift = summary.drift_um;
        card(`largest change of the gap, after ${duration(drift.time_of_largest_s)}`, `${fixed(drift.largest_E_SW, 1, true)} µm`);
        card("change of the gap at the end", `${fixed(drift.final_E_SW, 1, true)} µm`);
        if ("warm_up_s" in summary) card(summary.warm_up_s === null ? "the gap still drifts too fast at the end"
            : "the gap is steady from this time on", summary.warm_up_s === null ? "not warm" : duration(summary.warm_up_s));
    }
    const rises = Object.entries(summary?.probe_rises_K ?? {}).map(([name, list]) => [name, list.end]);
    if (rises.length) {
        const [name, most] = rises.reduce((a, b) => (b[1] > a[1] ? b : a));
        card(`largest rise of a probe: ${words(name)}`, `${fixed(most, 1, true)} K`);
    }
    if (summary?.energy_J) card(`${heatName(run)} over the run`, `${shown(summary.energy_J.generated / 1e6)} MJ`);
    if (summary?.reference) card(`difference from the published rises (if no rise is predicted: ${shown(summary.reference.rms_null_K)} K)`,
        `${shown(summary.reference.rms_residual_K)} K rms`);
    if (loads) {
        card("largest process force", `${shown(loads.operation.process_force_peak_N / 1000)} kN`);
        if (Math.abs(loads.drive.mean_power_W) >= 1) card("mean drive power", `${shown(loads.drive.mean_power_W / 1000)} kW`);
    }
    return make("ul", { class: "cards" }, cards);
}

function lead(run) {
    const drift = run.summary?.drift_um;
    if (!drift) return null;
    const strongest = Object.entries(drift.final_by_part ?? {}).slice(0, 2).map(([name, value]) =>
        `${words(name)} (${fixed(value, 1, true)} µm)`);
    const end = run.hours ? duration(3600 * run.hours[run.hours.length - 1]) : "the run";
    return make("p", { class: "lead" }, `After ${end} the gap between slide and table has `
        + `${drift.final_E_SW < 0 ? "closed" : "opened"} by ${fixed(Math.abs(drift.final_E_SW), 1)} µm at bottom dead point`
        + (strongest.length ? `; ${strongest.join(" and ")} ${strongest.length > 1 ? "contribute" : "contributes"} most.` : "."));
}

/** Columns of the history of some kinds as lines over hours. */
const historyLines = (run, ...kinds) => columnsOf(run.history, ...kinds).map((entry) => ({
    key: entry.of, name: words(entry.of), x: run.hours, y: entry.values }));

function temperatureSection(run) {
    if (!run.history) return null;
    const reference = run.summary?.reference;
    const probes = historyLines(run, "probe_temperature").map((line) => ({ ...line, y: line.y.map((value) => value - line.y[0]) }));
    if (reference?.rises_K) for (const line of probes) {
        const row = reference.rises_K[line.key];
        if (row) line.marks = [{ x: run.hours[run.hours.length - 1], y: row.reference }];
    }
    const joints = strongest(historyLines(run, "joint_temperature"), 10);
    return make("section", { id: "temperatures" }, make("h2", {}, "Temperatures"),
        lineChart({ id: "probes", title: "Rise of the probes", text: kelvinNote, x: ["time", "h"], y: ["rise", "K"],
            series: probes, markNote: reference?.source }),
        lineChart({ id: "joints", title: "Temperature of the joints", text: "Mean over both sides of all surfaces in contact"
            + (joints.length === 10 ? ", for the ten joints that change most." : "."), x: ["time", "h"], y: ["temperature", "°C"],
        zero: false, series: joints }), airChart(run));
}

function airChart(run) {
    const series = historyLines(run, "enclosed_air");
    return series.length ? lineChart({ id: "enclosures", title: "Temperature of the enclosed air", text: "", x: ["time", "h"],
        y: ["temperature", "°C"], zero: false, series }) : "";
}

/** The lines that change most, in their original order. */
function strongest(lines, count) {
    const change = (line) => line.y.reduce((most, value) => Math.max(most, Math.abs(value - line.y[0])), 0);
    const chosen = [...lines].sort((a, b) => change(b) - change(a)).slice(0, count);
    return lines.filter((line) => chosen.includes(line));
}

function heatSection(run) {
    if (!run.history || !run.summary?.energy_J) return null;
    const joints = historyLines(run, "joint_heat", "source_heat", "enclosed_air_power")
        .sort((a, b) => Math.max(...b.y) - Math.max(...a.y));
    if (joints.length === 0 && !run.summary.energy_J.generated) return null;
    const generated = run.hours.map((_, i) => joints.reduce((sum, line) => sum + line.y[i], 0));
    const air = column(run.history, "heat_to_air"), oil = column(run.history, "heat_to_oil");
    const balance = [{ name: heatName(run), y: generated, bold: true }, { name: "to the air", y: air },
        { name: "to the oil", y: oil }].filter((line) => line.y);
    if (!run.summary.energy_J.from_surfaces) balance.push({ name: "into the machine",
        y: generated.map((value, i) => value - (air?.[i] ?? 0) - (oil?.[i] ?? 0)) });
    const shownJoints = joints.slice(0, 8).filter((line) => Math.max(...line.y) > 0);
    return make("section", { id: "heat" }, make("h2", {}, "Heat"), flowFigure(run),
        lineChart({ id: "balance", title: "Heat flows over time", text: "The heat generated goes to the air or to the oil, "
            + "or warms the machine.", x: ["time", "h"], y: ["heat flow", "W"],
        series: balance.map((line) => ({ ...line, x: run.hours })) }),
        lineChart({ id: "joint-heat", title: heatName(run) === "friction heat" ? "Friction heat of the joints"
            : "Heat of joints and heat sources", text: joints.length > 8
            ? `The eight largest of ${joints.length}.` : "", x: ["time", "h"], y: ["heat", "W"], series: shownJoints }));
}

/** Contribution of each part to the gap at a time, largest first. */
function steps(run, hour) {
    const columns = columnsOf(run.contributions, "part_share");
    const hours = column(run.contributions, "time").map((second) => second / 3600);
    return mainSteps(columns.map((entry) => ({ name: words(entry.of), value: between(hours, entry.values, hour) })),
        "parts");
}

/** The steps of a waterfall, largest first; small ones are combined into one. */
function mainSteps(steps, kind) {
    const rows = [...steps].sort((a, b) => Math.abs(b.value) - Math.abs(a.value));
    const kept = rows.slice(0, 9).filter((row) => Math.abs(row.value) > 0.005 * Math.abs(rows[0].value));
    const rest = rows.slice(kept.length);
    if (rest.length) kept.push({ name: rest.length === 1 ? rest[0].name : `${rest.length} other ${kind}`,
        value: rest.reduce((sum, row) => sum + row.value, 0) });
    return kept;
}

/** Contribution of each heat source to the gap at a time of the summary's list. */
function causeSteps(entry) {
    const named = (group, what) => Object.entries(entry[group] ?? {}).map(([name, value]) =>
        ({ name: what ? `${what} ${words(name)}` : words(name), value }));
    const single = { oil: "oil", air: "ambient", start: "warm start", remainder: entry.fields ? "remainder" : "films over temperature" };
    return mainSteps([...named("friction", "friction in"), ...named("heat source"), ...named("surface", "surface"),
        ...Object.entries(single).map(([key, name]) => ({ name, value: entry[key] ?? 0 }))]
        .filter((row) => row.value !== 0), "causes");
}

function causeFigure(entry, end) {
    const last = Math.abs(entry.time_s - end) < 1e-6 * end;
    return waterfall({ id: last ? "causes-end" : "causes-largest", unit: "µm", total: "gap E_SW", rows: causeSteps(entry),
        title: last ? `Which heat causes the change at the end, after ${duration(end)}`
            : `Which heat causes the largest change, after ${duration(entry.time_s)}`,
        text: "Each cause counts with the effect of its heat anywhere in the machine up to this time, with the heat of all joints "
            + "as in the run. Oil and ambient count with the difference of their temperature from the start."
            + (entry.fields ? ` The shares were computed on ${entry.fields} fields of temperature instead of all; the last four of `
                + `them changed no share by more than ${entry.change.toPrecision(1)} µm. The remainder is the gap's change less all shares, ${fixed(entry.remainder, 2, true)} µm.` : ""),
        note: null });
}

function driftSection(run) {
    const drift = run.summary?.drift_um;
    if (!drift || !run.history) return null;
    const lines = historyLines(run, "dimension").map((line) => ({ ...line, name: line.key,
        bold: line.key === gapName }));
    const end = run.hours[run.hours.length - 1];
    const at = drift.time_of_largest_s / 3600;
    const falls = [];
    if (run.contributions) {
        const fall = (id, title, hour, exact) => {
            const rows = steps(run, hour);
            const miss = exact - rows.reduce((sum, row) => sum + row.value, 0);
            return waterfall({ id, title, text: "Solid bars open the gap, hatched bars close it. Each part counts with the "
                + "full effect of its own warming.", unit: "µm", rows, total: "gap E_SW", note: Math.abs(miss) > 0.05
                ? `The gap itself is at ${fixed(exact, 1, true)} µm at this time; contributions are interpolated linearly between time steps.` : null });
        };
        if (Math.abs(at - end) > 0.01 * end)
            falls.push(fall("waterfall-largest", `Which part causes the largest change, after ${duration(3600 * at)}`, at,
                drift.largest_E_SW));
        falls.push(fall("waterfall-end", `Which part causes the change at the end, after ${duration(3600 * end)}`, end,
            drift.final_E_SW));
    }
    for (const entry of drift.by_cause ?? []) falls.push(causeFigure(entry, 3600 * end));
    const known = lines.filter((line) => data.schema.dimensions[line.key]);
    return make("section", { id: "gap" }, make("h2", {}, "The gap between slide and table"),
        make("p", {}, "All values are changes since the start, at bottom dead point, with the press unloaded. Above zero the gap opens. "
            + "E_SW = E_BG − E_WG − E_CS − E_BC."),
        lineChart({ id: "drift", title: "The dimension chain over time", x: ["time", "h"], y: ["change", "µm"],
            series: lines }),
        table(["", `after ${duration(3600 * at)} [µm]`, `after ${duration(3600 * end)} [µm]`], known.map((line) =>
            [`${line.key}, ${data.schema.dimensions[line.key]}`, fixed(between(run.hours, line.y, at), 1, true),
                fixed(line.y[line.y.length - 1], 1, true)])), falls, forceChart(run));
}

/** What a tenth more of a coefficient, or 1 K more of a temperature, changes. */
function sensitivitySection(run) {
    const found = run.summary?.sensitivities;
    if (!found) return null;
    const more = (row) => (row.unit === "degC" ? "+1 K" : "+10 %");
    const rows = found.strongest.map((row) => ({ name: `${more(row)} ${words(row.coefficient)}`, value: row.E_SW_um,
        probe: row.largest_probe_K, at: row.unit ? `${shown(row.value)} ${row.unit === "degC" ? "°C" : row.unit}` : "a factor" }));
    const hasGap = rows.length > 0 && rows[0].value !== undefined;
    return make("section", { id: "sensitivities" }, make("h2", {}, "What the result depends on"),
        hasGap ? waterfall({ id: "sensitivity", title: `What moves the gap at the end, after ${duration(found.time_s)}`,
            text: "The ten strongest coefficients. Each bar is the effect of a tenth more of this coefficient alone, or of 1 K more of "
                + "a temperature, by the derivative of the run. Solid bars open the gap, hatched bars close it.",
            unit: "µm", rows, note: null }) : null,
        table(["", "value", ...(hasGap ? ["gap [µm]"] : []), "probe that changes most [K]"], rows.map((row) =>
            [row.name, row.at, ...(hasGap ? [fixed(row.value, 2, true)] : []), fixed(row.probe, 2, true)])),
        make("p", {}, "The file sensitivities.csv has all coefficients and probes."));
}

function loadsSection(run) {
    const { loads, joints, bearings } = run;
    if (!loads) return null;
    const angle = column(joints, "crank_angle");
    const x = ["crank angle past bottom dead point", "°"];
    const xTicks = [0, 60, 120, 180, 240, 300, 360];
    const force = (table, kind, name) => {
        const [a, b] = ["x", "y"].map((axis) => column(table, `${kind}_${axis}`, name));
        return a && b && a.map((value, i) => Math.hypot(value, b[i]) / 1000);
    };
    const pins = Object.keys(loads.joints ?? {}).filter((name) => !loads.joints[name].image).map((name) =>
        ({ name: words(name), x: angle, y: force(joints, "joint_force", name) })).filter((line) => line.y)
        .sort((a, b) => Math.max(...b.y) - Math.max(...a.y)).slice(0, 7);
    const parts = [make("h2", {}, "Loads over one turn"),
        make("p", {}, `At ${shown(loads.operation.speed_rpm)} rpm with ${shown(loads.operation.process_force_peak_N / 1000)} kN. `
            + `Stroke ${shown(loads.slide.stroke_mm, 4)} mm, largest drive torque ${shown(loads.drive.peak_torque_N_m)} N m.`)];
    if (run.motion) parts.push(linkageFigure(run.motion, joints, run.view?.directions));
    if (angle) parts.push(
        lineChart({ id: "slide", title: "Height of the slide", x, y: ["height", "mm"], xTicks,
            series: [{ name: "slide", x: angle, y: column(joints, "slide_height").map((value) => 1000 * value) }] }),
        lineChart({ id: "joint-forces", title: "Forces in the joints", text: "Magnitude of the net force, largest first.", x,
            y: ["force", "kN"], xTicks, series: pins }));
    if (bearings) parts.push(...bearingFigures(loads, bearings, x, xTicks, force));
    return make("section", { id: "loads" }, parts);
}

function bearingFigures(loads, bearings, x, xTicks, force) {
    const angle = column(bearings, "crank_angle");
    const names = columnsOf(bearings, "rigid_bearing_force_x").map((entry) => entry.of);
    const models = ["flexible", "rigid"].filter((model) => columnsOf(bearings, `${model}_bearing_force_x`).length);
    const lines = names.flatMap((name) => models.map((model) => ({ name: `${words(name)}, ${model}`, x: angle,
        y: force(bearings, `${model}_bearing_force`, name), model })));
    const strong = [...lines].filter((line) => line.model === models[0]).sort((a, b) => Math.max(...b.y) - Math.max(...a.y))
        .slice(0, 3);
    const shownLines = lines.filter((line) => strong.some((other) => other.name.split(",")[0] === line.name.split(",")[0]));
    return [lineChart({ id: "bearings", title: "Loads of the crankshaft's bearings", text: models.length > 1
        ? "With the flexible and with the rigid crankshaft." : "With the rigid crankshaft.", x, y: ["force", "kN"],
    xTicks, series: shownLines }),
    orderChart({ id: "orders", title: "Load spectrum of the bearings", text: "Amplitude of the load's magnitude at multiples of "
        + "the crank speed; 0 is the mean.", unit: "amplitude [kN]", series: shownLines.slice(0, 4).map((line) =>
        ({ name: line.name, values: amplitudes(line.x, line.y, 12) })) })];
}

/** Fourier amplitudes of a value over one turn [0, 360); trapezoid, for places that need not be evenly spaced. */
function amplitudes(degrees, values, most) {
    const turn = degrees[degrees.length - 1] >= 359.999;
    const xs = turn ? [...degrees] : [...degrees, 360], ys = turn ? [...values] : [...values, values[0]];
    return Array.from({ length: most + 1 }, (_, k) => {
        const part = (f) => {
            let sum = 0;
            for (let i = 1; i < xs.length; ++i) {
                const [a, b] = [xs[i - 1], xs[i]].map((x) => f(k * x * Math.PI / 180));
                sum += (xs[i] - xs[i - 1]) * (a * ys[i - 1] + b * ys[i]) / 2;
            }
            return sum / 360;
        };
        const [c, s] = [part(Math.cos), part(Math.sin)];
        return k === 0 ? Math.abs(c) : 2 * Math.hypot(c, s);
    });
}

function comparisonSection(run) {
    const reference = run.summary?.reference;
    if (!reference?.rises_K) return null;
    const rows = Object.entries(reference.rises_K).map(([name, { computed, reference: stated }]) => [words(name),
        fixed(computed, 2), fixed(stated, 2), fixed(computed - stated, 2, true)]);
    const better = reference.rms_residual_K < reference.rms_null_K;
    return make("section", { id: "comparison" }, make("h2", {}, "Against published or measured values"),
        make("p", {}, `Reference: ${reference.source}.`),
        table(["probe", "computed [K]", "reference [K]", "difference [K]"], rows),
        make("p", {}, `The root mean square of the differences is ${shown(reference.rms_residual_K)} K. Predicting no rise at all `
            + `would give ${shown(reference.rms_null_K)} K, so the model is `
            + (better ? `${shown(reference.rms_null_K / reference.rms_residual_K, 2)} times closer.`
                : "no better.")),
        reference.calibrated_on?.length ? make("p", {}, "Some keys of the case were calibrated on these values, so the agreement "
            + `proves nothing about these keys: ${reference.calibrated_on.join(", ")}.`)
            : make("p", {}, "The case names no keys that were calibrated on these values."));
}

// How far a run on a reduced model is off.
function certifiedText(certified) {
    if (certified.refused) return `There is no certified bound: ${certified.refused}.`;
    const probes = Object.values(certified.probes_K ?? {});
    const bounds = [
        certified.E_SW_um === undefined ? null : `the gap is at most ${certified.E_SW_um.toPrecision(2)} µm from that of the full model`,
        probes.length ? `probes are at most ${Math.max(...probes).toPrecision(2)} K from those of the full model` : null,
    ].filter(Boolean);
    return `Certified: at the end of the run ${bounds.join(", ")}.`;
}

function reducedParts(reduced) {
    const errors = [reduced.full_run, reduced.estimate, ...(reduced.errors ?? [])].filter(Boolean);
    return [make("h3", {}, "Error of the reduced model"),
        make("p", {}, `This run was computed on a reduced model of ${reduced.states} states (${reduced.model}). Largest differences `
            + "after the first minute, of probes and sides of joints, and of the gap:"),
        table(["compared with", "temperature [K]", "gap [µm]"],
            errors.map((error) => [error.of, fixed(error.temperature_K, 3), fixed(error.E_SW_um, 3)])),
        reduced.certified ? make("p", {}, certifiedText(reduced.certified)) : null,
        reduced.outside?.length ? make("p", {}, make("strong", {}, "Outside the range for which the model was built: "),
            reduced.outside.join("; ")) : null].filter(Boolean);
}

function trustSection(run) {
    const { facts: source } = run;
    const warnings = source.warnings ?? [];
    const check = run.summary?.adjoint_check;
    const left = source.left_out ?? [];
    return make("section", { id: "trust" }, make("h2", {}, "Warnings and assumptions"),
        source.interrupted ? make("p", {}, make("strong", {}, "The run was stopped before its end."), " ",
            "All results cover the time up to the stop.") : null,
        warnings.length ? make("ul", { class: "warnings" }, warnings.map((text) => make("li", {}, text)))
            : make("p", {}, "The run gave no warnings."),
        ...(run.summary?.reduced ? reducedParts(run.summary.reduced) : []),
        make("h3", {}, "What the model assumes"),
        make("ul", {}, [
            "Parts keep their material constants at all temperatures; each part has one material.",
            "Deformation is linear and elastic, and follows the temperature without delay.",
            "Bodies touch only in the joints; the case file states how heat passes there.",
            source.model?.half_model ? "The press is symmetric about x = 0; half of it is computed." : null,
            "The dimension chain is that of the unloaded press at bottom dead point.",
            left.length ? `Left out: ${left.join(", ")}.` : null,
        ].filter(Boolean).map((text) => make("li", {}, text))),
        run.summary?.energy_J?.relative_mismatch != null ? make("p", {}, "The energy balance closes to "
            + `${run.summary.energy_J.relative_mismatch.toExponential(0)} of the heat.`) : null,
        check ? make("p", {}, `The gap at ${duration(check.time_s)}, from the dimension chain and from the deformation: `
            + `${fixed(check.E_SW_um_by_adjoint, 3, true)} and ${fixed(check.E_SW_um_by_deformation, 3, true)} µm.`) : null);
}

function aboutSection(run) {
    const { facts: source, summary } = run;
    const model = summary?.model;
    const time = summary?.timings_s ? Object.values(summary.timings_s).reduce((a, b) => a + b, 0) : null;
    const rows = [["case", source.case?.name], ["case hash", source.case?.hash], ["computed with", `deadpoint ${source.version}`],
        ["folder", run.name]];
    if (model) rows.push(["mesh", `${model.cells} cells, ${model.heat_unknowns} unknowns of heat`
        + (model.deformation_unknowns ? `, ${model.deformation_unknowns} of deformation` : "")
        + (model.deformation_cells && model.deformation_cells !== model.cells
            ? ` on a mesh of ${model.deformation_cells} cells` : "")],
    ["time steps", `${summary.solution.steps}`], ["computing time", duration(time)]);
    return make("section", { id: "about" }, make("h2", {}, "Units, citation, and how to repeat this"),
        make("p", {}, "Lengths in mm, changes in µm, temperatures in °C and their differences in K, heat in W, forces in kN. "
            + "x and y lie across the crankshaft, z along it."),
        table(["", ""], rows),
        make("p", {}, `Cite as: deadpoint ${source.version}, thermal drift of mechanical presses at bottom dead point; case `
            + `“${source.case?.name}”, hash ${source.case?.hash}. The file CITATION.cff of the program has the full entry.`),
        run.case_file ? make("details", { class: "screen" }, make("summary", {}, "The case file as the program read it"),
            make("pre", {}, run.case_file)) : null);
}
