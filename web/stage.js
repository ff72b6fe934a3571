// The controls around the three-dimensional view.

const poses = { front: [1, 0, 0], side: [0, 1, 0] };

/** Section with the view of a run, or null where the folder has none. */
function viewSection(run) {
    if (!run.view) return null;
    const canvas = make("canvas", { tabindex: 0, "aria-label":
        "Machine in three dimensions. Arrow keys turn it, plus and minus zoom, space plays, comma and full stop step in "
        + "time, P asks for the temperature at the middle." });
    const still = make("img", { class: "still", alt: "Picture of the machine as last shown" });
    const clock = make("div", { class: "clock" });
    const scale = make("div", { class: "scale" });
    const stage = make("div", { class: "stage" }, canvas, still, clock, scale);
    const section = make("section", { id: "machine" }, make("h2", {}, "The machine in three dimensions"),
        make("p", {}, "Drag to turn the machine. Click a point to read its temperature. Zoom with two fingers, with the buttons, or, after a "
            + "click, with the wheel."), stage);
    let scene;
    try {
        scene = new MachineScene(canvas, run.view, run.motion);
    } catch (error) {
        stage.replaceChildren(make("p", { class: "note" }, "The view needs WebGL 2, which this browser does not provide. "
            + `The charts below work without it. (${error.message})`));
        return { section, dispose() {} };
    }
    const ui = new Stage(run, scene, { canvas, still, clock, scale, stage, section });
    return { section, start: () => ui.start(), pose: (name) => ui.pose(name), dispose: () => ui.dispose() };
}

class Stage extends ShapeStage {
    constructor(run, scene, elements) {
        super(scene, elements);
        Object.assign(this, { run, playing: false, picked: null });
        this.section.append(...this.timeControls(), this.lookControls(), this.pickOutput(), this.partControls(), this.help());
        this.listen();
    }

    /** To be called once the section is in the page. */
    start() {
        const { scene } = this;
        scene.state.magnification = scene.magnification;
        scene.update({ quantity: scene.quantities[0] });
        super.start();
        this.makeLabels();
        this.refresh();
        this.takeStill();
    }

    timeControls() {
        const end = this.scene.fields.end;
        this.play = make("button", { type: "button", click: () => this.toggle(), "aria-pressed": "false" }, "Play");
        this.time = make("input", { type: "range", min: 0, max: 1000, value: 1000, "data-control": "time",
            "aria-label": "time", input: () => { this.stop(); this.setTime(this.time.value / 1000 * end); } });
        this.timeText = make("output");
        return [make("div", { class: "controls" }, this.play, make("label", { class: "grow" }, "Time", this.time, this.timeText))];
    }

    lookControls() {
        const { scene } = this;
        const choose = make("select", { "data-control": "quantity", "aria-label": "what the colours show", change: () => {
            scene.update({ quantity: scene.quantities.find((entry) => entry.id === choose.value) });
            this.refresh();
        } }, scene.quantities.map((entry) => make("option", { value: entry.id }, entry.name)));
        const items = [make("label", {}, "Colours", choose)];
        if (scene.fields.displacement) items.push(this.magnifier());
        items.push(this.slicer());
        if (scene.half) items.push(this.box("Mirrored half", true, (on) => scene.update({ mirrored: on })));
        this.showProbes = scene.probes.length > 0 && scene.probes.length <= 6 && innerWidth > narrow;
        if (scene.probes.length) items.push(this.box("Probes", this.showProbes,
            (on) => { this.showProbes = on; this.makeLabels(); }));
        if (this.run.motion) items.push(this.crank());
        return make("div", {}, make("div", { class: "controls" }, items), this.viewControls());
    }

    magnifier() {
        const { scene } = this;
        const text = make("output", {}, `×${shown(scene.magnification)}`);
        const slider = make("input", { type: "range", min: 0, max: 20, value: 10, "data-control": "magnification",
            "aria-label": "deformation enlarged", input: () => {
                const magnification = scene.magnification * slider.value / 10;
                text.value = `×${shown(magnification)}`;
                scene.update({ magnification });
            } });
        return make("label", {}, "Deformation", slider, text);
    }

    crank() {
        const { scene } = this;
        const text = make("output", {}, "0°");
        const slider = make("input", { type: "range", min: 0, max: 357, step: 3, value: 0, "data-control": "crank",
            "aria-label": "crank angle past bottom dead point", input: () => {
                text.value = `${slider.value}°`;
                scene.update({ angle: Number(slider.value) });
            } });
        return make("label", {}, "Crank", slider, text);
    }

    pickOutput() {
        this.pickedText = make("p", { class: "picked", role: "status", "aria-live": "polite" });
        this.pickedChart = make("div");
        return make("div", { class: "screen" }, this.pickedText, this.pickedChart);
    }

    help() {
        const keys = [["← → ↑ ↓", "turn"], ["+ −", "zoom"], ["Space", "play or pause"], [", .", "step in time"],
            ["P", "temperature at the middle of the view"], ["Home", "first view"]];
        const view = this.run.view;
        return make("details", { class: "screen" }, make("summary", {}, "Keys, and the data of this view"),
            make("ul", { class: "keys" }, keys.map(([key, what]) => make("li", {}, make("kbd", {}, key), " ", what))),
            make("p", { class: "note" }, "The keys work while the view has the focus (Tab). The view shows "
                + `${view.parts.reduce((sum, part) => sum + part.triangles, 0)} triangles between nodes of the mesh`
                + (view.merged_within_m ? `, merged within ${shown(1000 * view.merged_within_m, 2)} mm and less` : "")
                + `, and ${view.coefficients.length} modes of the field at ${view.time_s.length} times. Leaving out further `
                + `modes changes no temperature by more than ${shown(view.error_of_modes_K, 2)} K (largest rise `
                + `${shown(view.largest_rise_K)} K)` + (view.displacement_m ? `; the deformation uses the first `
                + `${view.displacement_m.modes.length} of them and is accurate to about 1 %` : "") + `. Between the times, values are interpolated linearly. Cut faces are grey; the values inside are `
                + "in fields.pvd, for ParaView."));
    }

    moreKeys() {
        return { " ": () => this.toggle(), ",": () => this.step(-1), ".": () => this.step(1) };
    }

    pictureName() { return `${this.run.facts.case?.name ?? "machine"} ${this.clock.textContent}.png`; }

    /** Shows only the machine, over the whole window, for the pictures of `deadpoint report --pictures`. */
    pose(name) {
        document.body.classList.add("picture");
        const { scene } = this;
        this.showProbes = false;
        this.makeLabels();
        scene.resize();
        if (name === "cut") scene.update({ axis: "z", cut: (scene.low[2] + scene.high[2]) / 2 });
        scene.home(poses[name]);
        scene.render();
    }

    setTime(time) {
        this.scene.update({ time });
        this.refresh();
    }

    step(by) {
        this.stop();
        const end = this.scene.fields.end;
        this.setTime(Math.min(end, Math.max(0, this.scene.state.time + by * end / 50)));
    }

    toggle() { if (this.playing) this.stop(); else this.run_(); }

    stop() {
        this.playing = false;
        this.play.textContent = "Play";
        this.play.setAttribute("aria-pressed", "false");
    }

    /** Plays the whole run in ten seconds, from the start if it is at its end; in a few large steps if reduced motion is set. */
    run_() {
        const { fields, state } = this.scene;
        this.playing = true;
        this.play.textContent = "Pause";
        this.play.setAttribute("aria-pressed", "true");
        const from = state.time >= fields.end * 0.999 ? 0 : state.time;
        const began = performance.now();
        const seconds = 10;
        const frame = (now) => {
            if (!this.playing) return;
            const share = Math.max(0, now - began) / 1000 / seconds;
            const time = Math.min(fields.end, from + share * fields.end);
            this.setTime(time);
            if (time >= fields.end) return this.stop();
            if (reducedMotion.matches) setTimeout(() => frame(performance.now()), 1000);
            else requestAnimationFrame(frame);
        };
        requestAnimationFrame(frame);
    }

    /** Updates everything beside the picture from the state. */
    refresh() {
        const { state, fields } = this.scene;
        this.time.value = Math.round(1000 * state.time / fields.end);
        this.time.setAttribute("aria-valuetext", duration(state.time));
        this.timeText.value = duration(state.time);
        this.clock.textContent = duration(state.time);
        this.drawScale(state.quantity);
        this.tell();
        this.fillLabels();
    }

    drawScale(quantity) {
        if (this.scaled === quantity) return;
        this.scaled = quantity;
        const { ticks } = quantity;
        const wide = 26, high = 12, left = 14;
        const drawing = svg("svg", { width: wide * (ticks.length - 1) + 2 * left + 6, height: 46, class: "plain", role: "img",
            "aria-label": `${quantity.name} from ${shown(ticks[0])} to ${shown(ticks[ticks.length - 1])} ${quantity.unit}` });
        const title = svg("text", { x: left, y: 12 });
        title.textContent = `${quantity.name} [${quantity.unit}]`;
        drawing.append(title);
        ticks.forEach((tick, i) => {
            if (i + 1 < ticks.length) drawing.append(svg("rect", { x: left + wide * i, y: 17, width: wide, height: high,
                fill: `rgb(${heatColour(ticks.length > 2 ? i / (ticks.length - 2) : 0)})`, stroke: "#777777",
                "stroke-width": 0.5 }));
            const text = svg("text", { x: left + wide * i, y: 42, "text-anchor": "middle", class: "tick" });
            text.textContent = ticks.length > 8 && i % 2 ? "" : shown(tick, 3);
            drawing.append(text);
        });
        this.scale.replaceChildren(drawing);
    }

    ask(x, y) {
        this.picked = this.scene.pick(x, y);
        this.tell();
        this.pickedChart.replaceChildren();
        this.makeLabels();
        if (!this.picked) return;
        const { fields } = this.scene;
        const { vertices, weights, part } = this.picked;
        const courses = vertices.map((v) => fields.course(fields.temperature, v));
        const y_ = fields.times.map((_, j) => weights.reduce((sum, w, k) => sum + w * courses[k][j], 0) - 273.15);
        this.pickedChart.append(lineChart({ id: "picked", title: `The picked point of ${words(part.name)} over time`,
            x: ["time", "h"], y: ["temperature", "°C"], zero: false, level: "h3",
            series: [{ name: words(part.name), x: fields.times.map((time) => time / 3600), y: y_ }] }));
        redrawFigures();
    }

    tell() {
        if (!this.picked) {
            this.pickedText.textContent = "";
            return;
        }
        const { fields, state } = this.scene;
        const { vertices, weights, part } = this.picked;
        const mean = (values, i = 0, block = 1) => weights.reduce((sum, w, k) => sum + w * values[block * vertices[k] + i], 0);
        const kelvin = mean(fields.at(fields.temperature, state.time));
        let text = `${words(part.name)} at (${this.scene.originOf(this.picked).map((x) => fixed(1000 * x, 0)).join(", ")}) mm after `
            + `${duration(state.time)}: ${fixed(kelvin - 273.15, 1)} °C, rise ${fixed(kelvin - fields.initial, 1, true)} K`;
        if (fields.displacement) {
            const u = fields.at(fields.displacement, state.time);
            text += `, moved by (${[0, 1, 2].map((i) => fixed(1e6 * mean(u, i, 3), 1, true)).join(", ")}) µm`;
        }
        this.pickedText.textContent = text;
    }

    makeLabels() {
        for (const { element } of this.labels) element.remove();
        const marks = [...(this.showProbes ? this.scene.probes : []), ...(this.picked ? [this.picked] : [])];
        this.labels = marks.map((mark) => ({ element: make("span", { class: "label" }), mark }));
        for (const { element } of this.labels) this.stage.append(element);
        this.fillLabels();
        this.placeLabels();
    }

    fillLabels() {
        if (this.labels.length === 0) return;
        const { fields, state } = this.scene;
        const values = fields.at(fields.temperature, state.time);
        for (const { element, mark } of this.labels) {
            const kelvin = mark.weights.reduce((sum, w, k) => sum + w * values[mark.vertices[k]], 0);
            element.textContent = `${mark.name ? words(mark.name) : "picked"} ${fixed(kelvin - 273.15, 1)} °C`;
        }
    }

    dispose() {
        this.stop();
        super.dispose();
    }
}
