// The machine in three dimensions: temperature and enlarged deformation over time; it can be turned, cut open and queried.

// Light to dark, so that the order also holds without colour (ColorBrewer YlOrRd, Brewer and Harrower).
const heatColours = ["ffffcc", "ffeda0", "fed976", "feb24c", "fd8d3c", "fc4e2a", "e31a1c", "bd0026", "800026"]
    .map((text) => [0, 2, 4].map((i) => parseInt(text.slice(i, i + 2), 16)));
function heatColour(s) {
    const at = Math.min(1, Math.max(0, s)) * (heatColours.length - 1);
    const i = Math.min(heatColours.length - 2, Math.floor(at));
    return heatColours[i].map((value, k) => Math.round(value + (heatColours[i + 1][k] - value) * (at - i)));
}

/** Fields of a run at any time, from its modes. */
class Fields {
    constructor(view) {
        this.times = view.time_s;
        this.coefficients = view.coefficients;
        this.initial = view.initial_temperature_K;
        this.positions = restored(view.positions_m);
        this.temperature = this.modal(view.temperature_K);
        this.displacement = view.displacement_m ? this.modal(view.displacement_m) : null;
        this.end = this.times[this.times.length - 1];
    }
    modal(field) { return { base: restored(field.base), modes: field.modes.map(restored) }; }
    /** The whole field at a time [s], interpolated linearly between the stored times. */
    at(field, time) {
        const values = Float32Array.from(field.base);
        field.modes.forEach((mode, k) => {
            const factor = between(this.times, this.coefficients[k], time);
            for (let i = 0; i < values.length; ++i) values[i] += factor * mode[i];
        });
        return values;
    }
    /** One entry over all stored times. */
    course(field, entry) {
        return this.times.map((_, j) => field.modes.reduce((sum, mode, k) => sum + this.coefficients[k][j] * mode[entry],
            field.base[entry]));
    }
}

/** The quantities that can be shown in colours: name, unit, values at vertices from the fields. */
function quantities(fields) {
    const list = [{ id: "rise", name: "temperature rise", unit: "K",
        values: (time) => fields.at(fields.temperature, time).map((value) => value - fields.initial) },
    { id: "temperature", name: "temperature", unit: "°C",
        values: (time) => fields.at(fields.temperature, time).map((value) => value - 273.15) }];
    if (fields.displacement) {
        const component = (time, of) => {
            const u = fields.at(fields.displacement, time);
            return Float32Array.from({ length: u.length / 3 }, (_, i) => 1e6 * of(u[3 * i], u[3 * i + 1], u[3 * i + 2]));
        };
        list.push({ id: "moved", name: "displacement", unit: "µm", values: (time) => component(time, Math.hypot) },
            { id: "up", name: "displacement upwards", unit: "µm", values: (time) => component(time, (x, y) => y) });
    }
    return list;
}

/** Bounds of the colours of a quantity, the same at all times so that colours can be compared. */
function colourTicks(entry, fields) {
    let [low, high] = [Infinity, -Infinity];
    for (const time of fields.times) for (const value of entry.values(time)) {
        if (value < low) low = value;
        if (value > high) high = value;
    }
    if (high - low < 1e-3) return [Math.round(low), Math.round(low) + 1];  // nothing happens
    // The error of the modes must not add a band.
    if (Math.abs(low) < 0.03 * (high - low)) low = 0;
    return niceTicks(low, Math.max(high - 0.01 * (high - low), low + 1e-6), 9);
}

/** Pairs of vertices along the sharp edges (over 30 degrees) of a part, then those along its borders. */
function sharpEdges(positions, triangles) {
    const normals = [], edges = new Map();
    const at = (v) => [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
    for (let t = 0; t < triangles.length; t += 3) {
        const [a, b, c] = [at(triangles[t]), at(triangles[t + 1]), at(triangles[t + 2])];
        const u = b.map((x, i) => x - a[i]), w = c.map((x, i) => x - a[i]);
        const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
        const length = Math.hypot(...n) || 1;
        normals.push(n.map((x) => x / length));
        for (let i = 0; i < 3; ++i) {
            const [p, q] = [triangles[t + i], triangles[t + (i + 1) % 3]];
            const key = Math.min(p, q) * 65536 + Math.max(p, q);
            edges.set(key, [...(edges.get(key) ?? []), t / 3]);
        }
    }
    const sharp = [], border = [];
    for (const [key, sides] of edges) {
        const [m, n] = sides.map((side) => normals[side]);
        if (sides.length === 1 || m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < 0.87)
            (sides.length === 1 ? border : sharp).push(Math.floor(key / 65536), key % 65536);
    }
    return { sharp, border };
}

/** The scene: parts as meshes whose corners follow the fields. */
class MachineScene {
    constructor(canvas, view, motion) {
        const L = Libraries;
        this.canvas = canvas;
        this.fields = new Fields(view);
        this.quantities = quantities(this.fields);
        this.motion = motion;
        this.half = view.half_model;
        this.renderer = new L.WebGLRenderer({ canvas, antialias: true, alpha: false, preserveDrawingBuffer: true });
        this.renderer.setClearColor(0xffffff);
        this.renderer.localClippingEnabled = true;
        this.scene = new L.Scene();
        this.camera = new L.PerspectiveCamera(28, 1, 0.01, 200);
        this.scene.add(this.camera, new L.HemisphereLight(0xffffff, 0xd8d8d8, 2.3));
        const lamp = new L.DirectionalLight(0xffffff, 1.0);
        lamp.position.set(-0.4, 0.6, 1);
        this.camera.add(lamp);
        this.plane = new L.Plane(new L.Vector3(-1, 0, 0), 1e9);
        this.texture = new L.DataTexture(new Uint8Array(4), 1, 1);
        const clippingPlanes = [this.plane];
        const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
        this.materials = {
            front: new L.MeshLambertMaterial({ map: this.texture, flatShading: true, clippingPlanes, ...offset }),
            // Visible only where the cut opens a part. It is drawn before the edges behind it, so it looks like the cut face.
            back: new L.MeshBasicMaterial({ color: 0xb4b8bc, side: L.BackSide, clippingPlanes, polygonOffset: true,
                polygonOffsetFactor: -0.5, polygonOffsetUnits: -4 }),
            edge: new L.LineBasicMaterial({ color: 0x30363c, transparent: true, opacity: 0.6, clippingPlanes }),
        };
        this.measure();
        this.parts = view.parts.map((part) => this.makePart(part));
        this.probes = view.probes.map((probe) => this.mark(probe)).filter(Boolean);
        this.controls = new L.OrbitControls(this.camera, canvas);
        this.controls.enableDamping = false;
        this.controls.enableZoom = false;
        this.controls.addEventListener("change", () => this.render());
        this.state = { time: this.fields.end, magnification: 0, quantity: this.quantities[0], axis: "", cut: 0, flip: false,
            mirrored: this.half, angle: 0 };
        this.home();
    }

    measure() {
        const x = this.fields.positions;
        const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
        for (let i = 0; i < x.length; ++i) {
            low[i % 3] = Math.min(low[i % 3], x[i]);
            high[i % 3] = Math.max(high[i % 3], x[i]);
        }
        if (this.half) high[0] = Math.max(high[0], -low[0]);
        this.low = low;
        this.high = high;
        this.size = Math.hypot(...high.map((value, i) => value - low[i]));
        let most = 0;
        if (this.fields.displacement) for (const time of this.fields.times)
            for (const value of this.fields.at(this.fields.displacement, time)) most = Math.max(most, Math.abs(value));
        // Enlarged so that the largest movement is about 3 % of the machine: one, two or five times a power of ten.
        const wanted = most > 0 ? 0.03 * this.size / most : 0;
        const power = 10 ** Math.floor(Math.log10(wanted || 1));
        this.magnification = wanted > 0 ? power * [5, 2, 1].find((lead) => lead * power <= wanted * 1.0001) : 0;
    }

    makePart(part) {
        const L = Libraries;
        const triangles = unpacked(part.data);
        const geometry = new L.BufferGeometry();
        geometry.setAttribute("position", new L.BufferAttribute(new Float32Array(3 * part.vertices), 3));
        geometry.setAttribute("uv", new L.BufferAttribute(new Float32Array(2 * part.vertices).fill(0.5), 2));
        geometry.setIndex(new L.BufferAttribute(triangles, 1));
        const outside = triangles.subarray(0, 3 * (part.triangles - part.symmetry_triangles));
        const lines = new L.BufferGeometry();
        lines.setAttribute("position", geometry.attributes.position);
        const own = this.fields.positions.subarray(3 * part.first_vertex, 3 * (part.first_vertex + part.vertices));
        const { sharp, border } = sharpEdges(own, outside);
        lines.setIndex([...sharp, ...border]);
        const copies = [false, true].slice(0, this.half ? 2 : 1).map((mirrored) => {
            const group = new L.Group();
            group.matrixAutoUpdate = false;
            const front = new L.Mesh(geometry, this.materials.front);
            group.add(front, new L.Mesh(geometry, this.materials.back), new L.LineSegments(lines, this.materials.edge));
            for (const child of group.children) child.frustumCulled = false;
            this.scene.add(group);
            return { group, front, mirrored };
        });
        return { ...part, geometry, lines, copies, visible: true, range: { open: [triangles.length, Infinity],
            mirrored: [outside.length, sharp.length] } };
    }

    /** A probe as a mark on the vertex of its part next to it; null where the part is not shown. */
    mark(probe) {
        const part = this.parts.find((entry) => entry.name === probe.part);
        if (!part) return null;
        let best = 0, least = Infinity;
        for (let v = part.first_vertex; v < part.first_vertex + part.vertices; ++v) {
            const distance = Math.hypot(...[0, 1, 2].map((i) => this.fields.positions[3 * v + i] - probe.position_m[i]));
            if (distance < least) [best, least] = [v, distance];
        }
        return { name: probe.name, vertices: [best], weights: [1], copy: part.copies[0] };
    }

    home(direction = [0.75, 0.42, 1.25]) {
        const middle = this.low.map((value, i) => (value + this.high[i]) / 2);
        const L = Libraries;
        const back = new L.Vector3(...direction).normalize();
        const right = new L.Vector3(0, 1, 0).cross(back).normalize();
        const up = back.clone().cross(right);
        // As near as possible with all eight corners of the machine's box in view.
        const slope = 0.92 * Math.tan(this.camera.fov * Math.PI / 360);
        let distance = 0;
        for (let corner = 0; corner < 8; ++corner) {
            const place = new L.Vector3(...middle.map((value, i) => ((corner >> i) & 1 ? this.high : this.low)[i] - value));
            const reach = Math.max(Math.abs(place.dot(up)), Math.abs(place.dot(right)) / (this.camera.aspect || 1));
            distance = Math.max(distance, place.dot(back) + reach / slope);
        }
        this.camera.position.set(...middle).addScaledVector(back, distance);
        this.camera.near = distance / 50;
        this.camera.far = distance * 10;
        this.controls.target.set(...middle);
        this.controls.update();
    }

    turn(horizontal, vertical) {
        const offset = this.camera.position.clone().sub(this.controls.target);
        const place = new Libraries.Spherical().setFromVector3(offset);
        place.theta -= horizontal;
        place.phi = Math.min(Math.PI - 0.01, Math.max(0.01, place.phi - vertical));
        this.camera.position.copy(this.controls.target).add(offset.setFromSpherical(place));
        this.controls.update();
    }

    zoom(factor) {
        const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
        this.camera.position.copy(this.controls.target).add(offset);
        this.controls.update();
    }

    resize() {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        if (!width || !height) return;
        this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
        this.renderer.setSize(width, height, false);
        const before = this.camera.aspect;
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        if (Math.abs(before - this.camera.aspect) > 0.3) this.home();
        this.render();
    }

    /** Colours for the chosen quantity: one band between each two ticks of the scale. */
    paint() {
        const { quantity } = this.state;
        quantity.ticks ??= colourTicks(quantity, this.fields);
        const { ticks } = quantity;
        const bands = ticks.length - 1;
        const texels = new Uint8Array(4 * bands);
        for (let i = 0; i < bands; ++i)
            texels.set([...heatColour(bands > 1 ? i / (bands - 1) : 0), 255], 4 * i);
        this.texture.dispose();
        this.texture = new Libraries.DataTexture(texels, bands, 1);
        this.texture.colorSpace = Libraries.SRGBColorSpace;
        this.texture.needsUpdate = true;
        this.materials.front.map = this.texture;
    }

    /** Takes over changes of the state and draws. */
    update(change = {}) {
        Object.assign(this.state, change);
        const { time, magnification, quantity, mirrored } = this.state;
        if ("quantity" in change || !this.painted) { this.paint(); this.painted = true; }
        const values = quantity.values(time);
        const [low, high] = [quantity.ticks[0], quantity.ticks[quantity.ticks.length - 1]];
        const moved = this.fields.displacement ? this.fields.at(this.fields.displacement, time) : null;
        this.shownPositions = Float32Array.from(this.fields.positions);
        if (moved) for (let i = 0; i < moved.length; ++i) this.shownPositions[i] += magnification * moved[i];
        for (const part of this.parts) {
            const { position, uv } = part.geometry.attributes;
            position.array.set(this.shownPositions.subarray(3 * part.first_vertex, 3 * (part.first_vertex + part.vertices)));
            for (let v = 0; v < part.vertices; ++v)
                uv.array[2 * v] = Math.min(0.9999, Math.max(0.0001, (values[part.first_vertex + v] - low) / (high - low)));
            position.needsUpdate = uv.needsUpdate = true;
            part.geometry.computeBoundingSphere();
            // The symmetry plane is not a surface of the whole machine, and its outline is not an edge.
            const [faces, edges] = mirrored ? part.range.mirrored : part.range.open;
            part.geometry.setDrawRange(0, faces);
            part.lines.setDrawRange(0, edges);
            for (const copy of part.copies) {
                copy.group.visible = part.visible && (!copy.mirrored || mirrored);
                copy.group.matrix.copy(this.pose(part.body, copy.mirrored));
                copy.group.matrixWorldNeedsUpdate = true;
            }
        }
        this.cut();
        this.render();
    }

    /** Place of a body at the chosen crank angle. A body that exists twice has a mirror image, a body cut by the plane has none. */
    pose(body, mirrored) {
        const L = Libraries;
        const matrix = new L.Matrix4();
        const bodies = this.motion?.bodies ?? [];
        const entry = (mirrored && bodies.find((item) => item.name === body + "'"))
            || bodies.find((item) => item.name === body);
        if (entry && this.state.angle > 0) {
            const [x, y, angle] = this.poseAt(entry);
            matrix.makeRotationZ(angle).setPosition(x, y, 0);
        }
        return mirrored ? matrix.multiply(new L.Matrix4().makeScale(-1, 1, 1)) : matrix;
    }

    poseAt(entry) {
        const angles = this.motion.past_bottom_deg;
        let i = 0;
        while (i + 1 < angles.length && angles[i + 1] <= this.state.angle) ++i;
        return entry.poses[i];
    }

    cut() {
        const { axis, cut, flip } = this.state;
        const sign = flip ? 1 : -1;
        this.plane.normal.set(axis === "x" ? sign : 0, axis === "y" ? sign : 0, axis === "z" ? sign : 0);
        this.plane.constant = axis ? -sign * cut : 1e9;
        if (!axis) this.plane.normal.set(-1, 0, 0);
        this.materials.back.visible = Boolean(axis);
    }

    render() {
        this.renderer.render(this.scene, this.camera);
        this.afterRender?.();
    }

    /** The first visible thing that a ray meets. */
    hit(ray) {
        const fronts = this.parts.flatMap((part) => part.copies.filter((copy) => copy.group.visible)
            .map((copy) => copy.front));
        return ray.intersectObjects(fronts, false).find((entry) => this.plane.distanceToPoint(entry.point) >= 0);
    }

    /** Part, vertices and weights under a place of the canvas (-1..1 each way). */
    pick(x, y) {
        const ray = new Libraries.Raycaster();
        ray.setFromCamera(new Libraries.Vector2(x, y), this.camera);
        const hit = this.hit(ray);
        if (!hit) return null;
        const part = this.parts.find((entry) => entry.copies.some((copy) => copy.front === hit.object));
        return { part, copy: part.copies.find((copy) => copy.front === hit.object),
            vertices: [hit.face.a, hit.face.b, hit.face.c].map((v) => v + part.first_vertex), weights: hit.barycoord.toArray() };
    }

    /** Current place of a mark on the machine, with deformation and crank. */
    placeOf({ vertices, weights, copy }) {
        const place = [0, 1, 2].map((i) => weights.reduce((sum, w, k) => sum + w * this.shownPositions[3 * vertices[k] + i], 0));
        return new Libraries.Vector3(...place).applyMatrix4(copy.group.matrix).toArray();
    }

    /** The same place in the machine as meshed [m]. */
    originOf({ vertices, weights, copy }) {
        return [0, 1, 2].map((i) => (i === 0 && copy.mirrored ? -1 : 1)
            * weights.reduce((sum, w, k) => sum + w * this.fields.positions[3 * vertices[k] + i], 0));
    }

    /** Whether something visible lies between the camera and a place in the machine. */
    covered(point) {
        const place = new Libraries.Vector3(...point);
        const distance = place.distanceTo(this.camera.position);
        const ray = new Libraries.Raycaster(this.camera.position, place.sub(this.camera.position).normalize());
        const hit = this.hit(ray);
        return Boolean(hit) && hit.distance < distance - 0.005 * this.size;
    }

    /** A place in the machine as a place on the canvas [px], or null behind the camera. */
    project(point) {
        const place = new Libraries.Vector3(...point).project(this.camera);
        if (place.z > 1) return null;
        return [(place.x + 1) / 2 * this.canvas.clientWidth, (1 - place.y) / 2 * this.canvas.clientHeight];
    }

    dispose() {
        this.controls.dispose();
        for (const part of this.parts) { part.geometry.dispose(); part.lines.dispose(); }
        this.renderer.dispose();
        this.renderer.forceContextLoss();
    }
}
