// Where heat comes from and where it goes: bands as wide as the energy they carry.

/** Integral of a column over time (trapezoid). */
function integral(time, values) {
    let sum = 0;
    for (let i = 1; i < time.length; ++i) sum += (time[i] - time[i - 1]) * (values[i] + values[i - 1]) / 2;
    return sum;
}

/** Friction heat of each joint and the sinks over the whole run [J]. */
function energies(run) {
    const { energy_J: energy } = run.summary;
    const time = column(run.history, "time");
    const joints = columnsOf(run.history, "joint_heat", "source_heat", "enclosed_air_power")
        .map((entry) => ({ name: words(entry.of), value: integral(time, entry.values) }))
        .filter((entry) => entry.value > 0).sort((a, b) => b.value - a.value);
    // The history is sampled, the balance is exact. The difference is distributed evenly.
    const sampled = joints.reduce((sum, entry) => sum + entry.value, 0);
    for (const entry of joints) entry.value *= energy.generated / sampled;
    const sources = joints.slice(0, 9);
    const rest = joints.slice(9).reduce((sum, entry) => sum + entry.value, 0);
    if (rest > 0) sources.push({ name: `${joints.length - 9} other joints`, value: rest });
    const sinks = [];
    const place = (name, value) => (value > 0 ? sinks : sources).push({ name, value: Math.abs(value) });
    if (energy.to_air) place(energy.to_air > 0 ? "to the air" : "from the air", energy.to_air);
    if (energy.to_oil) place(energy.to_oil > 0 ? "to the oil" : "from the oil", energy.to_oil);
    if (energy.from_surfaces) place("held surfaces", -energy.from_surfaces);
    if (energy.stored) place(energy.stored > 0 ? "into the machine" : "out of the machine", energy.stored);
    return { sources, sinks };
}

function flowFigure(run) {
    const { sources, sinks } = energies(run);
    const total = sources.reduce((sum, entry) => sum + entry.value, 0);
    if (!(total > 0)) return null;
    const patterns = ["url(#dotted)", "url(#crossed)", "#9fb6c6", "#d9d2c0"];
    const draw = (width) => {
        const gap = 7, height = 340, top = 6, label = Math.min(230, width * 0.36), bar = 12;
        const scale = (height - 2 * top - gap * (Math.max(sources.length, sinks.length) - 1) - 40) / total;
        const drawing = svg("svg", { width, height, class: "plain", role: "img", "aria-label": "Heat of the whole run: from "
            + sources.map((s) => `${s.name} ${megajoules(s.value)}`).join(", ") + "; "
            + sinks.map((s) => `${s.name} ${megajoules(s.value)}`).join(", ") });
        const left = label, right = width - label, middle = (left + right) / 2;
        const trunkTop = (height - scale * total) / 2;
        const side = (list, x, anchor, toTrunk) => {
            const used = scale * list.reduce((sum, entry) => sum + entry.value, 0) + gap * (list.length - 1);
            let y = (height - used) / 2, trunk = trunkTop;
            const wanted = [];
            list.forEach((entry, i) => {
                const wide = scale * entry.value;
                const [x1, x2] = toTrunk > 0 ? [x + bar, middle - bar / 2] : [x - bar, middle + bar / 2];
                const bend = (x1 + x2) / 2;
                const fill = toTrunk > 0 ? palette[i % palette.length] : patterns[i % patterns.length];
                drawing.append(svg("path", { class: "band", fill, "fill-opacity": toTrunk > 0 ? 0.35 : 1, stroke: "#777777",
                    "stroke-width": 0.5, d: `M${x1} ${y}C${bend} ${y} ${bend} ${trunk} ${x2} ${trunk}v${wide}`
                        + `C${bend} ${trunk + wide} ${bend} ${y + wide} ${x1} ${y + wide}Z` }));
                drawing.append(svg("rect", { x: toTrunk > 0 ? x : x - bar, y, width: bar, height: Math.max(1, wide),
                    fill: toTrunk > 0 ? palette[i % palette.length] : "#555555" }));
                wanted.push(y + wide / 2);
                y += wide + gap;
                trunk += wide;
            });
            const spread = spreadLabels(wanted, 15, 9, height - 6);
            list.forEach((entry, i) => {
                const room = Math.floor(label / 6.4) - 9;
                const name = entry.name.length > room ? entry.name.slice(0, room - 1) + "…" : entry.name;
                const text = svg("text", { x: anchor === "end" ? x - 6 : x + 6, y: spread[i] + 4, "text-anchor": anchor });
                text.textContent = `${name} ${megajoules(entry.value)}`;
                drawing.append(text);
            });
        };
        side(sources, left, "end", 1);
        drawing.append(svg("rect", { x: middle - bar / 2, y: trunkTop, width: bar, height: scale * total, fill: "#444444" }));
        side(sinks, right, "start", -1);
        return drawing;
    };
    const rows = [...sources.map((s) => ["from " + s.name, s]), ...sinks.map((s) => [s.name, s])];
    return figure("flow", "Where the heat comes from and where it goes", "Energy of the whole press over the whole run. "
        + "Bands are as wide as the energy they carry.", draw, make("details", {}, make("summary", {}, "Figures of this chart"),
        table(["", "energy [MJ]", "share"], rows.map(([name, { value }]) =>
            [name, shown(value / 1e6, 4), `${shown(100 * value / total)} %`]))));
}
