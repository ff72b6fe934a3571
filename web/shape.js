// A machine in three dimensions: its parts, which can be turned, cut open, hidden and asked, and the controls around them.

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

/** Parts of a machine as meshes that can be turned, cut open, hidden and asked. Their colours are up to what derives from it. */
class MachineShape {
    /** @param shape  positions_m, parts and half_model, as in view.json
     *  @param points  in the picture where there are no parts [m] */
    constructor(canvas, shape, points = []) {
        const L = Libraries;
        this.canvas = canvas;
        this.positions = restored(shape.positions_m);
        this.half = shape.half_model;
        this.directions = shape.directions ?? { front: [0, 0, 1], left: [-1, 0, 0], up: [0, 1, 0] };
        this.renderer = new L.WebGLRenderer({ canvas, antialias: true, alpha: false, preserveDrawingBuffer: true });
        this.renderer.setClearColor(0xffffff);
        this.renderer.localClippingEnabled = true;
        this.scene = new L.Scene();
        this.camera = new L.PerspectiveCamera(28, 1, 0.01, 200);
        this.camera.up.set(...this.directions.up);
        this.scene.add(this.camera, new L.HemisphereLight(0xffffff, 0xd8d8d8, 2.3));
        const lamp = new L.DirectionalLight(0xffffff, 1.0);
        lamp.position.set(-0.4, 0.6, 1);
        this.camera.add(lamp);
        this.plane = new L.Plane(new L.Vector3(-1, 0, 0), 1e9);
        const clippingPlanes = [this.plane];
        const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
        this.materials = {
            front: new L.MeshLambertMaterial({ flatShading: true, clippingPlanes, ...offset }),
            // Visible only where the cut opens a part. It is drawn before the edges behind it, so it looks like the cut face.
            back: new L.MeshBasicMaterial({ color: 0xb4b8bc, side: L.BackSide, clippingPlanes, polygonOffset: true,
                polygonOffsetFactor: -0.5, polygonOffsetUnits: -4 }),
            edge: new L.LineBasicMaterial({ color: 0x30363c, transparent: true, opacity: 0.6, clippingPlanes }),
        };
        this.measure(points);
        this.parts = shape.parts.map((part) => this.makePart(part));
        this.controls = new L.OrbitControls(this.camera, canvas);
        this.controls.enableDamping = false;
        this.controls.enableZoom = false;
        this.controls.addEventListener("change", () => this.render());
        this.state = { axis: "", cut: 0, flip: false, mirrored: this.half };
    }

    measure(points) {
        const x = this.positions.length ? this.positions : points.flat();
        const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
        for (let i = 0; i < x.length; ++i) {
            low[i % 3] = Math.min(low[i % 3], x[i]);
            high[i % 3] = Math.max(high[i % 3], x[i]);
        }
        if (this.half) high[0] = Math.max(high[0], -low[0]);
        this.low = low;
        this.high = high;
        this.size = Math.hypot(...high.map((value, i) => value - low[i]));
    }

    /** The triangles of a part as they are drawn; those on the plane of symmetry last. */
    trianglesOf(part) { return unpacked(part.data); }

    /** Its material, or one for each range of its triangles. */
    skinOf() { return this.materials.front; }

    makePart(part) {
        const L = Libraries;
        const triangles = this.trianglesOf(part);
        const own = this.positions.subarray(3 * part.first_vertex, 3 * (part.first_vertex + part.vertices));
        const geometry = new L.BufferGeometry();
        geometry.setAttribute("position", new L.BufferAttribute(Float32Array.from(own), 3));
        geometry.setAttribute("uv", new L.BufferAttribute(new Float32Array(2 * part.vertices).fill(0.5), 2));
        geometry.setIndex(new L.BufferAttribute(triangles, 1));
        const outside = triangles.subarray(0, 3 * (part.triangles - part.symmetry_triangles));
        const lines = new L.BufferGeometry();
        lines.setAttribute("position", geometry.attributes.position);
        const { sharp, border } = sharpEdges(own, outside);
        lines.setIndex([...sharp, ...border]);
        const skin = this.skinOf(part, geometry);
        const copies = [false, true].slice(0, this.half ? 2 : 1).map((mirrored) => {
            const group = new L.Group();
            group.matrixAutoUpdate = false;
            const front = new L.Mesh(geometry, skin);
            group.add(front, new L.Mesh(geometry, this.materials.back), new L.LineSegments(lines, this.materials.edge));
            for (const child of group.children) child.frustumCulled = false;
            this.scene.add(group);
            return { group, front, mirrored };
        });
        return { ...part, geometry, lines, skin, copies, visible: true, range: { open: [triangles.length, Infinity],
            mirrored: [outside.length, sharp.length] } };
    }

    /** A direction by its shares to the front, to the right and upwards, as who stands in front has them. */
    towards([front, right, up]) {
        const { directions } = this;
        return [0, 1, 2].map((i) => front * directions.front[i] - right * directions.left[i] + up * directions.up[i]);
    }

    /** Looks at the whole machine. @param from  where the camera is: shares to the front, to the right and upwards */
    home(from = [1.25, 0.75, 0.42]) {
        const middle = this.low.map((value, i) => (value + this.high[i]) / 2);
        const L = Libraries;
        const back = new L.Vector3(...this.towards(from)).normalize();
        const right = new L.Vector3(...this.directions.up).cross(back).normalize();
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
        const L = Libraries;
        const offset = this.camera.position.clone().sub(this.controls.target);
        // In coordinates to the right, upwards and to the front; spherical ones have their pole upwards.
        const { front, left, up } = this.directions;
        const own = new L.Matrix4().set(-left[0], up[0], front[0], 0, -left[1], up[1], front[1], 0, -left[2], up[2], front[2], 0,
            0, 0, 0, 1);
        const place = new L.Spherical().setFromVector3(offset.applyMatrix4(own.clone().invert()));
        place.theta -= horizontal;
        place.phi = Math.min(Math.PI - 0.01, Math.max(0.01, place.phi - vertical));
        this.camera.position.copy(this.controls.target).add(offset.setFromSpherical(place).applyMatrix4(own));
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

    /** Takes over changes of the state and draws. */
    update(change = {}) {
        Object.assign(this.state, change);
        const { mirrored } = this.state;
        for (const part of this.parts) {
            part.geometry.computeBoundingSphere();
            // The symmetry plane is not a surface of the whole machine, and its outline is not an edge.
            const [faces, edges] = mirrored ? part.range.mirrored : part.range.open;
            part.geometry.setDrawRange(0, faces);
            part.lines.setDrawRange(0, edges);
            for (const copy of part.copies) {
                copy.group.visible = part.visible && (!copy.mirrored || mirrored);
                copy.group.matrix.copy(this.pose(part, copy.mirrored));
                copy.group.matrixWorldNeedsUpdate = true;
            }
        }
        this.cut();
        this.render();
    }

    /** Place of a part, or of its mirror image. */
    pose(part, mirrored) {
        const matrix = new Libraries.Matrix4();
        return mirrored ? matrix.makeScale(-1, 1, 1) : matrix;
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
            triangle: hit.faceIndex,
            vertices: [hit.face.a, hit.face.b, hit.face.c].map((v) => v + part.first_vertex), weights: hit.barycoord.toArray() };
    }

    /** Place of a mark: a place in space, or one on a part as it is drawn now. */
    placeOf({ at, vertices, weights, copy }) {
        if (at) return at;
        const positions = this.shownPositions ?? this.positions;
        const place = [0, 1, 2].map((i) => weights.reduce((sum, w, k) => sum + w * positions[3 * vertices[k] + i], 0));
        return new Libraries.Vector3(...place).applyMatrix4(copy.group.matrix).toArray();
    }

    /** The same place in the machine as meshed [m]. */
    originOf({ vertices, weights, copy }) {
        return [0, 1, 2].map((i) => (i === 0 && copy.mirrored ? -1 : 1)
            * weights.reduce((sum, w, k) => sum + w * this.positions[3 * vertices[k] + i], 0));
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

// Where the camera is: shares to the front, to the right and upwards.
const presets = [["First view", undefined], ["From the front", [1, 0, 0]], ["From the left", [0, -1, 0]], ["From the right", [0, 1, 0]],
    ["From the back", [-1, 0, 0]], ["From above", [0.001, 0, 1]]];

/** The controls around a machine in three dimensions. */
class ShapeStage {
    /** @param elements  canvas, still (an image for printing), scale, stage (around the canvas) and section */
    constructor(scene, elements) {
        Object.assign(this, elements, { scene, labels: [] });
    }

    /** To be called once the section is in the page. */
    start() {
        const { scene } = this;
        scene.afterRender = () => this.placeLabels();
        this.observer = new ResizeObserver(() => scene.resize());
        this.observer.observe(this.canvas);
        scene.resize();
        scene.home();
    }

    viewControls() {
        const { scene } = this;
        const views = presets.map(([name, direction]) => make("button", { type: "button", click: () => {
            scene.home(direction); scene.render(); } }, name));
        const zoom = [["+", 1 / 1.25, "closer"], ["−", 1.25, "further away"]].map(([text, factor, label]) =>
            make("button", { type: "button", "aria-label": label, click: () => scene.zoom(factor) }, text));
        const save = make("button", { type: "button", click: () => this.save() }, "Save as picture");
        return make("div", { class: "controls" }, views, zoom, save);
    }

    slicer() {
        const { scene } = this;
        const axis = make("select", { "data-control": "slice", "aria-label": "cut open across", change: () => apply() },
            [["", "not cut"], ["x", "across x"], ["y", "across y"], ["z", "across z"]].map(([value, name]) =>
                make("option", { value }, name)));
        const slider = make("input", { type: "range", min: 0, max: 200, value: 100, "aria-label": "place of the cut",
            input: () => apply(), class: "hidden" });
        const text = make("output");
        const flip = make("button", { type: "button", class: "hidden", click: () => { scene.state.flip = !scene.state.flip;
            apply(); } }, "Other side");
        const apply = () => {
            const i = "xyz".indexOf(axis.value);
            for (const element of [slider, flip]) element.classList.toggle("hidden", i < 0 || !axis.value);
            const cut = axis.value ? scene.low[i] + (scene.high[i] - scene.low[i]) * slider.value / 200 : 0;
            text.value = axis.value ? `${fixed(1000 * cut, 0)} mm` : "";
            scene.update({ axis: axis.value, cut });
        };
        return make("label", {}, "Cut", axis, slider, text, flip);
    }

    box(name, on, change) {
        const input = make("input", { type: "checkbox", checked: on, "data-control": name, change: () => change(input.checked) });
        return make("label", {}, input, name);
    }

    partControls() {
        const bodies = new Map();
        for (const part of this.scene.parts) bodies.set(part.body, [...(bodies.get(part.body) ?? []), part]);
        const boxes = [];
        const toggle = (part, on, box) => { part.visible = on; box.checked = on; };
        const items = [...bodies].flatMap(([body, parts]) => {
            const children = parts.map((part) => {
                const box = make("input", { type: "checkbox", checked: true, "data-part": part.name, change: () => {
                    part.visible = box.checked; this.scene.update(); } });
                boxes.push([part, box]);
                return make("li", { class: "part" }, make("label", {}, box, " ", words(part.name)));
            });
            const mine = boxes.slice(-parts.length);
            const whole = make("input", { type: "checkbox", checked: true, "data-body": body, change: () => {
                for (const [part, box] of mine) toggle(part, whole.checked, box);
                this.scene.update();
            } });
            return [make("li", { class: "body" }, make("label", {}, whole, " ", this.swatch(body), words(body))),
                ...(parts.length > 1 || parts[0].name !== body ? children : [])];
        });
        return make("details", { class: "screen" }, make("summary", {}, `Show or hide parts (${boxes.length})`),
            make("ul", { class: "partlist" }, items));
    }

    /** What shows the colour of a body beside its name. */
    swatch() { return null; }

    /** What keys do besides turning and zooming: key, action. */
    moreKeys() { return {}; }

    listen() {
        const { canvas, scene } = this;
        let down = null;
        canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
        canvas.addEventListener("pointerup", (event) => {
            if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 5) {
                const box = canvas.getBoundingClientRect();
                this.ask((event.clientX - box.left) / box.width * 2 - 1, 1 - (event.clientY - box.top) / box.height * 2);
            }
            down = null;
        });
        canvas.addEventListener("focus", () => { scene.controls.enableZoom = true; });
        canvas.addEventListener("blur", () => { scene.controls.enableZoom = false; });
        canvas.addEventListener("touchstart", () => { scene.controls.enableZoom = true; }, { passive: true });
        const step = 0.12;
        const actions = {
            ArrowLeft: () => scene.turn(-step, 0), ArrowRight: () => scene.turn(step, 0), ArrowUp: () => scene.turn(0, step),
            ArrowDown: () => scene.turn(0, -step), "+": () => scene.zoom(1 / 1.15), "=": () => scene.zoom(1 / 1.15),
            "-": () => scene.zoom(1.15), Home: () => { scene.home(); scene.render(); }, p: () => this.ask(0, 0),
            P: () => this.ask(0, 0), ...this.moreKeys(),
        };
        canvas.addEventListener("keydown", (event) => {
            const action = !event.ctrlKey && !event.metaKey && !event.altKey && actions[event.key];
            if (!action) return;
            event.preventDefault();
            action();
        });
        this.beforePrint = () => this.takeStill();
        addEventListener("beforeprint", this.beforePrint);
    }

    takeStill() {
        this.scene.render();
        this.still.src = this.canvas.toDataURL("image/png");
    }

    /** The view with its scale as a PNG file. */
    async save() {
        this.scene.render();
        const copy = make("canvas", { width: this.canvas.width, height: this.canvas.height });
        const context = copy.getContext("2d");
        context.drawImage(this.canvas, 0, 0);
        if (this.scale.firstChild) await this.drawScaleInto(context, copy);
        make("a", { href: copy.toDataURL("image/png"), download: this.pictureName().replace(/[^\w.-]+/g, "-") }).click();
    }

    async drawScaleInto(context, copy) {
        const drawing = this.scale.firstChild.cloneNode(true);
        drawing.setAttribute("style", "font: 12.5px Helvetica, Arial, sans-serif");
        const image = new Image();
        image.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(new XMLSerializer().serializeToString(drawing));
        await image.decode();
        const ratio = this.canvas.width / this.canvas.clientWidth;
        context.drawImage(image, 12 * ratio, copy.height - (image.height + 10) * ratio, image.width * ratio,
            image.height * ratio);
    }

    placeLabels() {
        const { scene } = this;
        for (const { element, mark } of this.labels) {
            const place = scene.project(scene.placeOf(mark));
            element.classList.toggle("hidden", !place || place[0] > scene.canvas.clientWidth - 20);
            if (place) [element.style.left, element.style.top] = place.map((x) => `${x}px`);
        }
        clearTimeout(this.covering);
        this.covering = setTimeout(() => this.coverLabels(), 120);
    }

    /** Dims the labels of hidden places. */
    coverLabels() {
        for (const { element, mark } of this.labels)
            element.classList.toggle("behind", this.scene.covered(this.scene.placeOf(mark)));
    }

    dispose() {
        this.observer?.disconnect();
        removeEventListener("beforeprint", this.beforePrint);
        this.scene.dispose();
    }
}
