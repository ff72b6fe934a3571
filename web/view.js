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
function quantities(fields, up) {
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
            { id: "up", name: "displacement upwards", unit: "µm", values: (time) => component(time, (...u) => u[0] * up[0] + u[1] * up[1] + u[2] * up[2]) });
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

/** The scene: parts as meshes whose corners follow the fields. */
class MachineScene extends MachineShape {
    constructor(canvas, view, motion) {
        super(canvas, view);
        this.fields = new Fields(view);
        this.quantities = quantities(this.fields, this.directions.up);
        this.motion = motion;
        this.texture = new Libraries.DataTexture(new Uint8Array(4), 1, 1);
        this.materials.front.map = this.texture;
        this.measureMotion();
        this.probes = view.probes.map((probe) => this.mark(probe)).filter(Boolean);
        Object.assign(this.state, { time: this.fields.end, magnification: 0, quantity: this.quantities[0], angle: 0 });
        this.home();
    }

    measureMotion() {
        let most = 0;
        if (this.fields.displacement) for (const time of this.fields.times)
            for (const value of this.fields.at(this.fields.displacement, time)) most = Math.max(most, Math.abs(value));
        // Enlarged so that the largest movement is about 3 % of the machine: one, two or five times a power of ten.
        const wanted = most > 0 ? 0.03 * this.size / most : 0;
        const power = 10 ** Math.floor(Math.log10(wanted || 1));
        this.magnification = wanted > 0 ? power * [5, 2, 1].find((lead) => lead * power <= wanted * 1.0001) : 0;
    }

    /** A probe as a mark on the vertex of its part next to it; null where the part is not shown. */
    mark(probe) {
        const part = this.parts.find((entry) => entry.name === probe.part);
        if (!part) return null;
        let best = 0, least = Infinity;
        for (let v = part.first_vertex; v < part.first_vertex + part.vertices; ++v) {
            const distance = Math.hypot(...[0, 1, 2].map((i) => this.positions[3 * v + i] - probe.position_m[i]));
            if (distance < least) [best, least] = [v, distance];
        }
        return { name: probe.name, vertices: [best], weights: [1], copy: part.copies[0] };
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
        const { time, magnification, quantity } = this.state;
        if ("quantity" in change || !this.painted) { this.paint(); this.painted = true; }
        const values = quantity.values(time);
        const [low, high] = [quantity.ticks[0], quantity.ticks[quantity.ticks.length - 1]];
        const moved = this.fields.displacement ? this.fields.at(this.fields.displacement, time) : null;
        this.shownPositions = Float32Array.from(this.positions);
        if (moved) for (let i = 0; i < moved.length; ++i) this.shownPositions[i] += magnification * moved[i];
        for (const part of this.parts) {
            const { position, uv } = part.geometry.attributes;
            position.array.set(this.shownPositions.subarray(3 * part.first_vertex, 3 * (part.first_vertex + part.vertices)));
            for (let v = 0; v < part.vertices; ++v)
                uv.array[2 * v] = Math.min(0.9999, Math.max(0.0001, (values[part.first_vertex + v] - low) / (high - low)));
            position.needsUpdate = uv.needsUpdate = true;
        }
        super.update();
    }

    /** Place of a body at the chosen crank angle. A body that exists twice has a mirror image, a body cut by the plane has none. */
    pose(part, mirrored) {
        const matrix = new Libraries.Matrix4();
        const bodies = this.motion?.bodies ?? [];
        const entry = (mirrored && bodies.find((item) => item.name === part.body + "'"))
            || bodies.find((item) => item.name === part.body);
        if (entry && this.state.angle > 0) {
            const [x, y, angle] = this.poseAt(entry);
            matrix.makeRotationZ(angle).setPosition(x, y, 0);
        }
        return matrix.multiply(super.pose(part, mirrored));
    }

    poseAt(entry) {
        const angles = this.motion.past_bottom_deg;
        let i = 0;
        while (i + 1 < angles.length && angles[i + 1] <= this.state.angle) ++i;
        return entry.poses[i];
    }
}
