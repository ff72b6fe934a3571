// The linkage in motion over one turn of the crank, drawn in the plane.

const turned = ([x, y, angle], [px, py]) =>
    [x + Math.cos(angle) * px - Math.sin(angle) * py, y + Math.sin(angle) * px + Math.cos(angle) * py];

/** Corners of the hull around points (Andrew's monotone chain). */
function hull(points) {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    if (sorted.length < 3) return sorted;
    const half = (list) => {
        const chain = [];
        for (const p of list) {
            while (chain.length > 1) {
                const [a, b] = chain.slice(-2);
                if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
                chain.pop();
            }
            chain.push(p);
        }
        return chain.slice(0, -1);
    };
    return [...half(sorted), ...half(sorted.reverse())];
}

/** Where who sees x to the right and y up stands, by the named directions of a view. */
function seenFrom({ front, left }) {
    return { front: front[2], back: -front[2], left: left[2], right: -left[2] };
}

function linkageFigure(motion, joints, directions) {
    const { bodies, joints: pins, past_bottom_deg: angles } = motion;
    const all = pins.flatMap((joint) => joint.places);
    const [lowX, highX] = [0, 1].map((k) => Math[k ? "max" : "min"](...all.map((p) => p[0])));
    const [lowY, highY] = [0, 1].map((k) => Math[k ? "max" : "min"](...all.map((p) => p[1])));
    const size = Math.max(highX - lowX, highY - lowY);
    const moving = bodies.map((body, i) => ({ ...body, i })).filter((body) => !body.ground);
    const names = [...new Set(moving.map((body) => body.name.replace(/'+$/, "")))];
    const look = (body) => style(names.indexOf(body.name.replace(/'+$/, "")));
    let now = 0;
    const readout = make("output");

    const draw = (width) => {
        const margin = 0.1 * size;
        const [w, h] = [highX - lowX + 2 * margin, highY - lowY + 2 * margin];
        const scale = Math.min(width / w, (width < narrow ? 340 : 430) / h);
        const at = ([x, y]) => [(x - lowX + margin) * scale, (highY - y + margin) * scale];
        const path = (points, close = false) => "M" + points.map((p) => at(p).map((v) => v.toFixed(1)).join(" ")).join("L")
            + (close ? "Z" : "");
        const drawing = svg("svg", { width: w * scale, height: h * scale, class: "plain", role: "img",
            "aria-label": `Linkage ${Math.round(angles[now])} degrees past bottom dead point` });
        for (const joint of pins)
            drawing.append(svg("path", { d: path(joint.places, true), fill: "none", stroke: "#bbbbbb", "stroke-width": 0.9 }));
        for (const joint of pins.filter((entry) => entry.kind === "slide")) {
            const along = joint.places.map((p) => p[0] * joint.direction[0] + p[1] * joint.direction[1]);
            const [p, q] = [Math.min(...along), Math.max(...along)].map((s) => {
                const shift = s - along[0];
                return joint.places[0].map((x, k) => x + joint.direction[k] * (shift + Math.sign(shift || -1) * 0.04 * size));
            });
            drawing.append(svg("path", { d: path([p, q]), stroke: "#6b6b6b", "stroke-width": 5, "stroke-opacity": 0.35 }));
        }
        for (const body of moving) {
            const own = pins.filter((joint) => joint.body_a === body.i || joint.body_b === body.i);
            const places = hull(own.map((joint) => joint.places[now]));
            const { colour, dash } = look(body);
            drawing.append(svg("path", { d: path(places, places.length > 2), fill: places.length > 2 ? colour : "none",
                "fill-opacity": 0.18, stroke: colour, "stroke-width": body.slide ? 6 : 4, "stroke-linejoin": "round",
                "stroke-linecap": "round", "stroke-dasharray": dash, class: "body" }));
        }
        for (const joint of pins) {
            const [x, y] = at(joint.places[now]);
            const ground = bodies[joint.body_a].ground || bodies[joint.body_b].ground;
            drawing.append(joint.kind === "slide"
                ? svg("rect", { x: x - 5, y: y - 7, width: 10, height: 14, fill: "white", stroke: "#222222" })
                : ground ? svg("path", { d: `M${x} ${y}l-8 13h16Z`, fill: "white", stroke: "#222222" })
                    : svg("circle", { cx: x, cy: y, r: 4.5, fill: "white", stroke: "#222222", "stroke-width": 1.5 }));
        }
        const legend = make("ul", { class: "legend" }, names.map((name, i) => make("li", {}, lineSample(style(i), true), " ",
            words(name))));
        return [drawing, legend];
    };

    const height = column(joints, "slide_height"), force = column(joints, "process_force");
    const degrees = column(joints, "crank_angle");
    let entry = null;
    const show = (index) => {
        now = index;
        slider.value = index;
        readout.value = `${Math.round(angles[index])}°` + (height
            ? `, slide ${shown(1000 * between(degrees, height, angles[index]))} mm up`
            : "") + (force ? `, force ${shown(between(degrees, force, angles[index]) / 1000)} kN` : "");
        entry?.redraw(true);
    };
    const slider = make("input", { type: "range", min: 0, max: angles.length - 1, value: 0, "data-control": "linkage",
        "aria-label": "crank angle past bottom dead point", input: () => { stop(); show(Number(slider.value)); } });
    let playing = false;
    const stop = () => { playing = false; button.textContent = "Play"; };
    const button = make("button", { type: "button", click: () => {
        if (playing) return stop();
        playing = true;
        button.textContent = "Pause";
        const next = () => {
            if (!playing || !slider.isConnected) return;
            show((now + (reducedMotion.matches ? 10 : 1)) % angles.length);
            setTimeout(next, reducedMotion.matches ? 1000 : 40);
        };
        next();
    } }, "Play");
    const side = directions && Object.entries(seenFrom(directions)).find(([, share]) => share > 0.5)?.[0];
    const seen = side ? ` Seen from the ${side}, x to the right.` : "";
    const element = figure("linkage", "The linkage in motion", "Thin lines are the paths of the joints. Triangles are fixed pivots, "
        + "squares are sliding joints." + seen, draw, make("div", { class: "controls" }, button,
        make("label", { class: "grow" }, "Crank", slider, readout)));
    element.classList.add("linkage");
    entry = figures[figures.length - 1];
    show(0);
    return element;
}
