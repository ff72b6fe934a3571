// The machine of a case before it is solved: parts, joints, faces by their conditions, probes, the dimension chain, and
// in red what the check found wrong.

const sketch = data.sketch;
const severityColours = { error: "#d7191c", warning: "#e0a800" };
const conditions = { film: ["#56b4e9", "film of its own (air, oil)"], fixed: ["#7b4ea3", "fixed temperature"], heat: ["#c8641e", "heat source"],
    insulated: ["#8a8f94", "insulated"], chain: ["#3b6fb6", "face of the dimension chain"] };
const interfaceColour = "#009e73";
const bodyColours = ["#cfd6dc", "#dccdb0", "#bcd4c0", "#d6c1d4", "#c3cae6", "#e3c8b8", "#cddcb4", "#b5d6da", "#e0bfc4", "#d9d5a8"];
const bodies = [...new Set(sketch.parts.map((part) => part.body))];
const bodyColour = (body) => bodyColours[bodies.indexOf(body) % bodyColours.length];

// ---------------------------------------------------------------- what is wrong

/** The worst of the findings about a thing, null where there is none. */
function severityOf(kind, name) {
    const about = data.findings.filter((finding) => finding.things.some((thing) => thing.kind === kind && thing.name === name));
    return about.some((finding) => finding.severity === "error") ? "error" : about.length ? "warning" : null;
}
const worst = (...severities) => (severities.includes("error") ? "error" : severities.find(Boolean) ?? null);
const severityOfPart = (part) => worst(severityOf("part", part.name), severityOf("body", part.body));
const severityOfMark = (mark) => (mark.kind === "heated" ? null : severityOf(mark.kind, mark.name));
const severityOfJoint = (name) => worst(severityOf("joint", name),
    ...data.findings.flatMap((finding) => finding.things.filter((thing) => thing.kind === "interface"
        && thing.name.startsWith(`${name}.`)).map(() => finding.severity)));

// ---------------------------------------------------------------- places

const joined = (boxes) => boxes.filter(Boolean).reduce((sum, [low, high]) => (sum
    ? [sum[0].map((x, i) => Math.min(x, low[i])), sum[1].map((x, i) => Math.max(x, high[i]))] : [low, high]), null);
const middleOf = ([low, high]) => low.map((x, i) => (x + high[i]) / 2);
const pointBox = (point) => [point, point];

/** The ends of a joint's axis, or of the guide of a slide [m]. */
function jointLine(joint, low, high) {
    const [x, y] = joint.at_m;
    const spans = joint.elements_m.length ? joint.elements_m.flat() : [low[2], high[2]];
    const depth = joint.box ? [joint.box[0][2], joint.box[1][2]] : [Math.min(...spans), Math.max(...spans)];
    const size = Math.hypot(...high.map((value, i) => value - low[i]));
    if (joint.kind === "revolute") return [[x, y, depth[0] - 0.04 * size], [x, y, depth[1] + 0.04 * size]];
    const [dx, dy] = joint.direction.map((value) => value / Math.hypot(...joint.direction));
    const z = (depth[0] + depth[1]) / 2;
    const along = joint.box ? [0, 1].flatMap((i) => [0, 1].map((k) => (joint.box[i][0] - x) * dx + (joint.box[k][1] - y) * dy))
        : [-0.1 * size, 0.1 * size];
    return [Math.min(...along) - 0.04 * size, Math.max(...along) + 0.04 * size].map((s) => [x + s * dx, y + s * dy, z]);
}

/** All places that the case states, for a picture without parts. */
function statedPoints() {
    const points = [...sketch.joints.map(({ at_m: at }) => [...at, 0]), ...sketch.probes.map((probe) => probe.at_m)];
    return points.length ? points.flatMap((p) => [p, [p[0], p[1], 0.1], [p[0] + 0.1, p[1] + 0.1, 0]]) : [[0, 0, 0], [1, 1, 1]];
}

// ---------------------------------------------------------------- the scene

/** A tube of six sides along a line [m]. */
function tube(points, radius) {
    const L = Libraries;
    const corners = [], index = [];
    for (let i = 0; i + 1 < points.length; ++i) {
        const [from, to] = [new L.Vector3(...points[i]), new L.Vector3(...points[i + 1])];
        const along = to.clone().sub(from).normalize();
        const across = new L.Vector3(...(Math.abs(along.x) < 0.9 ? [1, 0, 0] : [0, 1, 0])).cross(along).normalize();
        const other = along.clone().cross(across);
        const first = corners.length / 3;
        for (const end of [from, to]) for (let k = 0; k < 6; ++k) {
            const angle = Math.PI * k / 3;
            const corner = end.clone().addScaledVector(across, radius * Math.cos(angle)).addScaledVector(other, radius * Math.sin(angle));
            corners.push(corner.x, corner.y, corner.z);
        }
        for (let k = 0; k < 6; ++k) {
            const [a, b] = [first + k, first + (k + 1) % 6];
            index.push(a, b, a + 6, b, b + 6, a + 6);
        }
    }
    const geometry = new L.BufferGeometry();
    geometry.setAttribute("position", new L.BufferAttribute(new Float32Array(corners), 3));
    geometry.setIndex(index);
    return geometry;
}

class SketchScene extends MachineShape {
    constructor(canvas) {
        super(canvas, sketch, statedPoints());
        this.boxes = new Map(this.parts.map((part) => [part.name, this.boxOf(part)]));
        this.layers = { joints: this.group(), probes: this.group(), chain: this.group(), sought: this.group() };
        Object.assign(this.state, { interfaces: true, conditions: true, through: false, spread: 0 });
        this.drawJoints();
        this.drawProbes();
        this.dimensions = this.drawChain();
        sketch.sought.forEach((sought) => this.drawSought(sought));
        sketch.overlaps.forEach((overlap) => this.ball(this.layers.sought, overlap.at_m, 0.009, severityColours.warning));
        this.home();
    }

    group() {
        const group = new Libraries.Group();
        this.scene.add(group);
        return group;
    }

    boxOf(part) {
        const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
        for (let i = 3 * part.first_vertex; i < 3 * (part.first_vertex + part.vertices); ++i) {
            low[i % 3] = Math.min(low[i % 3], this.positions[i]);
            high[i % 3] = Math.max(high[i % 3], this.positions[i]);
        }
        return [low, high];
    }

    /** Triangles that share their marks follow each other. */
    trianglesOf(part) {
        const corners = unpacked(part.data), groups = unpacked(part.groups);
        const outside = part.triangles - part.symmetry_triangles;
        const order = Array.from(groups, (_, t) => t).sort((a, b) => (a >= outside) - (b >= outside) || groups[a] - groups[b] || a - b);
        part.runs = [];
        order.forEach((t, i) => {
            const last = part.runs[part.runs.length - 1];
            if (last && last.group === groups[t] && i !== outside) ++last.count;
            else part.runs.push({ group: groups[t], first: i, count: 1 });
        });
        return Uint16Array.from(order.flatMap((t) => [corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]]));
    }

    skinOf(part, geometry) {
        return part.runs.map(({ first, count }, i) => {
            geometry.addGroup(3 * first, 3 * count, i);
            const material = this.materials.front.clone();
            material.clippingPlanes = [this.plane];  // a clone has planes of its own
            return material;
        });
    }

    marksOf(group) { return sketch.groups[group].map((mark) => sketch.marks[mark]); }

    /** Colour of the triangles of a part that share a group of marks, and whether something is wrong with them. */
    colourOf(part, group) {
        const marks = this.marksOf(group);
        const wrong = worst(severityOfPart(part), ...marks.map(severityOfMark));
        if (wrong) return [severityColours[wrong], true];
        if (this.state.interfaces && marks.some((mark) => mark.kind === "interface")) return [interfaceColour, false];
        // Air at whatever is exposed is the rule and keeps the colour of the body.
        const condition = marks.filter((mark) => mark.condition in conditions && !(mark.exposed && mark.condition === "film"))
            .sort((a, b) => (a.kind === "heated") - (b.kind === "heated"))[0];
        if (this.state.conditions && condition) return [conditions[condition.condition][0], false];
        return [bodyColour(part.body), false];
    }

    update(change = {}) {
        Object.assign(this.state, change);
        for (const part of this.parts) part.runs.forEach(({ group }, i) => {
            const [colour, wrong] = this.colourOf(part, group);
            const material = part.skin[i];
            const glass = this.state.through && !wrong;
            material.color.set(colour);
            Object.assign(material, { transparent: glass, opacity: glass ? 0.16 : 1, depthWrite: !glass });
        });
        super.update();
    }

    /** Parts are drawn away from the middle of the machine. */
    pose(part, mirrored) {
        const { spread } = this.state ?? {};
        const matrix = super.pose(part, mirrored);
        if (!spread) return matrix;
        const middle = middleOf([this.low, this.high]);
        const away = middleOf(this.boxes.get(part.name)).map((x, i) => spread * (x - middle[i]));
        return matrix.multiply(new Libraries.Matrix4().setPosition(...away));
    }

    /** A thing that is seen faintly through what covers it. */
    solid(layer, geometry, colour) {
        const L = Libraries;
        const seen = new L.Mesh(geometry, new L.MeshBasicMaterial({ color: colour }));
        const faint = new L.Mesh(geometry, new L.MeshBasicMaterial({ color: colour, transparent: true, opacity: 0.35, depthTest: false,
            depthWrite: false }));
        faint.renderOrder = 2;
        layer.add(seen, faint);
    }
    line(layer, points, colour, width = 0.0016) { this.solid(layer, tube(points, width * this.size), colour); }
    ball(layer, at, width, colour) {
        this.solid(layer, new Libraries.SphereGeometry(width * this.size, 12, 8).translate(...at), colour);
    }

    drawJoints() {
        this.jointLines = new Map();
        for (const joint of sketch.joints) {
            const ends = jointLine(joint, this.low, this.high);
            this.jointLines.set(joint.name, ends);
            this.line(this.layers.joints, ends, severityColours[severityOfJoint(joint.name)] ?? "#1d2327");
        }
        if (!this.parts.length) this.drawLinks();
    }

    /** Bodies as lines between their joints, where there are no parts. */
    drawLinks() {
        for (const body of new Set(sketch.joints.flatMap((joint) => joint.bodies))) {
            const places = sketch.joints.filter((joint) => joint.bodies.includes(body)).map(({ at_m: at }) => [...at, 0]);
            if (places.length > 1) this.line(this.layers.joints, places, "#8a8f94", 0.004);
        }
    }

    drawProbes() {
        for (const probe of sketch.probes)
            this.ball(this.layers.probes, probe.at_m, 0.006, severityColours[severityOf("probe", probe.name)] ?? "#111111");
    }

    /** Dimension lines beside the machine, with their lengths. */
    drawChain() {
        const pairs = [["E_SW", "table", "slide"], ["E_WG", "ground", "table"], ["E_CS", "slide", "crank"], ["E_BG", "ground", "crank"]];
        const places = sketch.chain, step = 0.045 * this.size, z = (this.low[2] + this.high[2]) / 2;
        const { stroke } = places, right = stroke && [stroke[1], -stroke[0]];
        const outside = stroke && Math.min(...[0, 1, 2, 3].map((corner) => [this.low, this.high][corner & 1][0] * right[0]
            + [this.low, this.high][corner >> 1][1] * right[1]));
        return pairs.filter(([, from, to]) => places[from] && places[to]).map(([name, from, to]) => {
            const [low, high] = [places[from], places[to]], aside = outside - step * (name === "E_BG" ? 3 : 1.6);
            const put = (a, s) => [a * right[0] + s * stroke[0], a * right[1] + s * stroke[1], z];
            const [bottom, top] = [low, high].map((place) => place[0] * stroke[0] + place[1] * stroke[1]);
            this.line(this.layers.chain, [put(aside, bottom), put(aside, top)], conditions.chain[0], 0.0022);
            for (const [end, s] of [[low, bottom], [high, top]])
                this.line(this.layers.chain, [put(aside - 0.3 * step, s), put(end[0] * right[0] + end[1] * right[1], s)],
                    conditions.chain[0], 0.0007);
            return { name, at: put(aside, (bottom + top) / 2), length: Math.abs(top - bottom) };
        });
    }

    /** A face that the case asks for and that is not there, as a red outline where it was sought. */
    drawSought(sought) {
        const lines = this.outlineOf(sought);
        for (const line of lines) this.line(this.layers.sought, line, severityColours.error, 0.0022);
        sought.box = joined(lines.flat().map(pointBox));
    }

    outlineOf({ kind, axis, centre_m: centre, diameter_m: diameter, position_m: position, within_m: within, parts }) {
        const [low, high] = joined(parts.map((name) => this.boxes.get(name))) ?? [this.low, this.high];
        const put = (u, v, w) => { const p = [u, v]; p.splice(axis, 0, w); return p; };
        const others = [0, 1, 2].filter((i) => i !== axis);
        if (kind === "cylinder") return [low[axis], high[axis]].map((w) => Array.from({ length: 49 }, (_, k) =>
            put(centre[0] + diameter / 2 * Math.cos(Math.PI * k / 24), centre[1] + diameter / 2 * Math.sin(Math.PI * k / 24), w)));
        if (kind === "plane" && position !== null) {
            const [u, v] = others.map((i) => [low[i], high[i]]);
            return [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]].map(([i, k]) => put(u[i], v[k], position))];
        }
        return within ? [[0, 0, 0], [0, 1, 1], [1, 0, 1], [1, 1, 0]].flatMap((corner) => [0, 1, 2].map((i) => [0, 1].map((end) =>
            corner.map((c, k) => within[k === i ? end : c][k])))) : [];
    }

    /** The box around a thing that a finding names; null where it is not in the picture. */
    boxOfThing({ kind, name }) {
        const path = kind === "interface" ? `joints.${name.replace(".", ".interfaces.")}` : `surfaces.${name}`;
        const sought = sketch.sought.filter((entry) => entry.path === path || entry.path.startsWith(`${path}.`)).map((entry) => entry.box);
        const marked = sketch.marks.filter((mark) => mark.kind === kind && mark.name === name).map((mark) => mark.box);
        // A part that could not be built is where its faces were sought.
        if (kind === "part") return this.boxes.get(name)
            ?? joined(sketch.sought.filter((entry) => entry.parts.includes(name)).map((entry) => entry.box));
        if (kind === "body") return joined(this.parts.filter((part) => part.body === name).map((part) => this.boxes.get(part.name)));
        if (kind === "probe") return pointBox(sketch.probes.find((probe) => probe.name === name).at_m);
        const joint = this.jointLines.get(kind === "joint" ? name : name.split(".")[0]);
        return joined([...marked, ...sought]) ?? (joint ? joined(joint.map(pointBox)) : null);
    }

    /** Looks at a box from where the camera is. */
    lookAt(box) {
        const L = Libraries;
        const [low, high] = box;
        const size = Math.max(0.12 * this.size, 1.3 * Math.hypot(...high.map((x, i) => x - low[i])));
        const middle = new L.Vector3(...middleOf(box));
        const back = this.camera.position.clone().sub(this.controls.target).normalize();
        this.camera.position.copy(middle).addScaledVector(back, size / (2 * Math.tan(this.camera.fov * Math.PI / 360)));
        this.camera.near = size / 100;
        this.controls.target.copy(middle);
        this.controls.update();
        this.render();
    }
}

// ---------------------------------------------------------------- controls

class SketchStage extends ShapeStage {
    constructor(scene, elements) {
        super(scene, elements);
        this.focused = null;
        this.picked = make("p", { class: "picked", role: "status", "aria-live": "polite" });
        this.shown = { joints: true, probes: true, chain: true, names: scene.parts.length > 0 && innerWidth > 560 };
        this.section.append(this.layerControls(), this.viewControls(), make("div", { class: "screen" }, this.picked), legend(),
            scene.parts.length ? this.partControls() : "", this.contents());
        this.listen();
    }

    start() {
        this.scene.update();
        super.start();
        this.makeLabels();
        this.takeStill();
    }

    pictureName() { return `${document.querySelector("h1").textContent} unsolved.png`; }
    swatch(body) { return swatch(bodyColour(body)); }

    layerControls() {
        const { scene } = this;
        const layer = (name, key) => this.box(name, true, (on) => {
            this.shown[key] = scene.layers[key].visible = on;
            this.makeLabels();
            scene.render();
        });
        const spread = make("input", { type: "range", min: 0, max: 20, value: 0, "data-control": "spread", "aria-label": "parts apart",
            input: () => scene.update({ spread: spread.value / 10 }) });
        this.throughBox = this.box("See through", false, (through) => scene.update({ through }));
        const items = [this.box("Faces of joints", true, (interfaces) => scene.update({ interfaces })),
            this.box("Conditions", true, (conditions) => scene.update({ conditions })), layer("Joints", "joints"), layer("Probes", "probes"),
            layer("Dimension chain", "chain"), this.box("Names", this.shown.names, (on) => { this.shown.names = on; this.makeLabels(); }),
            this.throughBox, make("label", {}, "Apart", spread), this.slicer()];
        if (scene.half) items.push(this.box("Mirrored half", true, (mirrored) => scene.update({ mirrored })));
        return make("div", { class: "controls" }, items);
    }

    /** Everything by name; a click looks at it. */
    contents() {
        const entry = (kind, name, note) => make("li", {}, make("button", { type: "button", class: "look", click: () =>
            this.look({ kind, name }) }, words(name)), note ? ` ${note}` : "");
        const list = (title, items) => (items.length ? [make("p", { class: "quiet" }, title), make("ul", { class: "partlist" }, items)] : []);
        const faces = sketch.marks.filter((mark) => mark.kind === "surface");
        const interfaces = [...new Set(sketch.marks.filter((mark) => mark.kind === "interface").map((mark) => mark.name))];
        return make("details", { class: "screen" }, make("summary", {}, "Joints, faces and probes by name"),
            list("Joints", sketch.joints.map((joint) => entry("joint", joint.name, joint.bodies.map(words).join(" – ")))),
            list("Faces of joints", interfaces.map((name) => entry("interface", name))),
            list("Surfaces", faces.map((mark) => entry("surface", mark.name,
                `${conditions[mark.condition]?.[1] ?? ""} ${shown(1e4 * mark.area_m2)} cm²`))),
            list("Probes", sketch.probes.map((probe) => entry("probe", probe.name, words(probe.part)))));
    }

    look(thing) {
        const box = this.scene.boxOfThing(thing);
        if (!box) return;
        this.stage.scrollIntoView({ block: "nearest" });
        this.scene.lookAt(box);
    }

    /** Looks at what a finding is about, through the parts before it. */
    focus(finding) {
        this.focused = finding;
        const box = joined(finding.things.map((thing) => this.scene.boxOfThing(thing)));
        this.makeLabels();
        if (!box) return;
        this.throughBox.querySelector("input").checked = true;
        this.scene.update({ through: true });
        this.stage.scrollIntoView({ block: "nearest" });
        this.scene.lookAt(box);
        this.takeStill();
    }

    makeLabels() {
        const { scene, shown: on } = this;
        for (const { element } of this.labels) element.remove();
        this.labels = [];
        const label = (at, text, kind = "") => {
            const element = make("span", { class: `label ${kind}` }, text);
            this.labels.push({ element, mark: { at }, wrong: kind.startsWith("wrong") });
            this.stage.append(element);
        };
        if (on.names && on.joints) for (const [name, ends] of scene.jointLines) label(ends[1], words(name), "plain");
        if (on.names && on.probes) for (const probe of sketch.probes) label(probe.at_m, words(probe.name));
        if (on.chain) for (const { name, at, length } of scene.dimensions) label(at, `${name} ${shown(1000 * length, 4)} mm`, "plain");
        for (const overlap of sketch.overlaps) label(overlap.at_m, `overlap ${shown(1000 * overlap.depth_m)} mm`);
        for (const [at, findings] of this.findingsByPlace()) {
            const first = findings.includes(this.focused) ? this.focused : findings[0];
            const more = findings.length > 1 ? ` (and ${findings.length - 1} more here)` : "";
            label(at, first.message + more, `wrong ${first.severity} ${first === this.focused ? "focused" : ""}`);
        }
        this.placeLabels();
    }

    /** Findings by the middle of what they are about; errors first. */
    findingsByPlace() {
        const places = new Map();
        for (const severity of ["error", "warning"])
            for (const finding of data.findings.filter((entry) => entry.severity === severity)) {
                const box = finding.things.map((thing) => this.scene.boxOfThing(thing)).find(Boolean);
                if (!box) continue;
                const at = middleOf(box), key = at.map((x) => x.toFixed(3)).join();
                places.set(key, [at, [...(places.get(key)?.[1] ?? []), finding]]);
            }
        return places.values();
    }

    coverLabels() {
        for (const { element, mark, wrong } of this.labels)
            element.classList.toggle("behind", !wrong && this.scene.covered(mark.at));
    }

    ask(x, y) {
        const hit = this.scene.pick(x, y);
        if (!hit) {
            this.picked.textContent = "";
            return;
        }
        const run = hit.part.runs.find(({ first, count }) => hit.triangle >= first && hit.triangle < first + count);
        const marks = this.scene.marksOf(run.group).map((mark) => (mark.kind === "interface" ? `${mark.name} (side ${mark.side})`
            : `${mark.kind === "heated" ? "heated by" : "surface"} ${mark.name}` + (mark.condition in conditions && mark.kind === "surface"
                ? ` (${conditions[mark.condition][1]})` : "")));
        this.picked.textContent = `${words(hit.part.name)} of ${words(hit.part.body)} at (${this.scene.originOf(hit)
            .map((value) => fixed(1000 * value, 0)).join(", ")}) mm: ${marks.join(", ") || "no joint, surface or heat here"}`;
    }
}

const swatch = (colour) => make("span", { class: "swatch", style: `background:${colour}` });

function legend() {
    const used = new Set(sketch.marks.filter((mark) => !(mark.exposed && mark.condition === "film")).map((mark) => mark.condition));
    const entries = [...(sketch.marks.some((mark) => mark.kind === "interface") ? [[interfaceColour, "face of a joint"]] : []),
        ...Object.entries(conditions).filter(([key]) => used.has(key)).map(([, entry]) => entry),
        ...["error", "warning"].filter((severity) => data.findings.some((finding) => finding.severity === severity))
            .map((severity) => [severityColours[severity], severity])];
    return make("ul", { class: "legend" }, entries.map(([colour, name]) => make("li", {}, swatch(colour), name)));
}

// ---------------------------------------------------------------- the page

const count = (number, word) => `${number} ${word}${number === 1 ? "" : "s"}`;

function findingsSection(focus) {
    const items = data.findings.map((finding) => make("li", { class: finding.severity },
        make("button", { type: "button", class: "look", click: () => focus(finding) }, finding.message),
        make("p", { class: "note" }, [finding.path, finding.place].filter(Boolean).join(", ")),
        finding.help ? make("p", {}, finding.help) : null));
    return make("section", { id: "findings" }, make("h2", {}, "What the check found"),
        items.length ? make("ol", { class: "findings" }, items) : make("p", {}, "Nothing is wrong as far as the check can tell."));
}

function missingSection() {
    if (!data.missing.length) return null;
    return make("section", { id: "missing" }, make("h2", {}, "What is not in the picture"),
        make("p", {}, "These could not be built. Mend what the check found first; some of this follows from it."),
        make("ul", { class: "warnings" }, data.missing.map((entry) => make("li", {}, make("strong", {}, entry.path), ` ${entry.message}`))));
}

function machineSection() {
    const canvas = make("canvas", { tabindex: 0, "aria-label": "Machine in three dimensions. Arrow keys turn it, plus and minus zoom, "
        + "P tells what is in the middle." });
    const still = make("img", { class: "still", alt: "Picture of the machine as last shown" });
    const scale = make("div", { class: "scale hidden" });
    const stage = make("div", { class: "stage" }, canvas, still, scale);
    const section = make("section", { id: "machine" }, make("h2", {}, "The machine as the case describes it"),
        make("p", {}, "Drag to turn it. Click a face to read what it is."), stage);
    try {
        return { section, ui: new SketchStage(new SketchScene(canvas), { canvas, still, scale, stage, section }) };
    } catch (error) {
        stage.replaceChildren(make("p", { class: "note" }, `The view needs WebGL 2, which this browser does not provide. (${error.message})`));
        return { section, ui: null };
    }
}

function startCheck() {
    const page = document.getElementById("page");
    const errors = data.findings.filter((finding) => finding.severity === "error").length;
    const { section, ui } = machineSection();
    page.querySelector("h1").after(make("p", { class: "quiet" }, `deadpoint ${data.version}, before solving`),
        make("p", { class: "lead" }, `${count(errors, "error")}, ${count(data.findings.length - errors, "warning")}. `
            + `${count(sketch.parts.length, "part")} of ${bodies.length === 1 ? "1 body" : `${bodies.length} bodies`}, `
            + `${count(sketch.joints.length, "joint")}, ${count(sketch.probes.length, "probe")}.`));
    page.prepend(make("a", { class: "skip", href: "#findings" }, "Skip to what the check found"));
    page.append(...[section, findingsSection((finding) => ui?.focus(finding)), missingSection()].filter(Boolean));
    ui?.start();
    window.checked = ui;
    document.body.dataset.ready = "true";
}
startCheck();
