// The page of a study: families of curves, the table of all points, and the map where two axes cross.

const study = data.sweep;
const main = document.getElementById("page");
const limited = study.limits.largest_um !== null || study.limits.end_um !== null;
const pointNamed = new Map(study.points.map((point) => [point.name, { ...point, ...data.points[point.name] }]));
const probes = [...new Set(study.points.flatMap((point) => Object.keys(point.figures?.rises_at_end_K ?? {})))];

/** The places of a set: the steps of its axes and the point computed there. */
function placesOf(set) {
    const places = [];
    for (const point of pointNamed.values())
        for (const place of point.places) if (place.set === set.name)
            places.push({ set, point, steps: set.axes.map((axis) => axis.labels.indexOf(place.steps[axis.name])) });
    return places.sort((a, b) => a.steps.reduce((order, step, i) => order || step - b.steps[i], 0));
}
const sets = study.sets.map((set) => ({ ...set, places: placesOf(set) }));
const placeAt = (set, steps) => set.places.find((place) => place.steps.every((step, i) => step === steps[i]));
const placeName = ({ set, steps }) => (steps.length ? steps.map((step, i) => `${words(set.axes[i].name)} ${set.axes[i].labels[step]}`)
    .join(", ") : "base case");
const inWindow = ({ set, steps }) => set.window?.points > 0 && steps.every((step, i) =>
    set.window.axes[set.axes[i].name].includes(set.axes[i].labels[step]));
const stateWords = { done: "computed", kept: "computed before", failed: "failed", left: "not computed" };

function select(label, control, options, chosen, change) {
    const choose = make("select", { "data-control": control, change: () => change(choose.selectedIndex) },
        options.map((text) => make("option", {}, text)));
    choose.selectedIndex = chosen;
    return make("label", {}, label, choose);
}

// ---------------------------------------------------------------- what comes first

function studyLead() {
    const done = study.points.filter((point) => point.figures);
    const parts = [done.length === study.points.length ? `All ${done.length} points are computed.`
        : `${done.length} of ${study.points.length} points are computed.`];
    const drifting = sets.flatMap((set) => set.places).filter((place) => place.point.figures?.E_SW)
        .sort((a, b) => Math.abs(a.point.figures.E_SW.largest_um) - Math.abs(b.point.figures.E_SW.largest_um));
    if (drifting.length > 1) {
        const tell = (place) => `${fixed(place.point.figures.E_SW.largest_um, 1, true)} µm at most, with ${placeName(place)}`;
        parts.push(`The gap between slide and table changes least, by ${tell(drifting[0])}, and most, by `
            + `${tell(drifting[drifting.length - 1])}.`);
    }
    return make("p", { class: "lead" }, parts.join(" "));
}

function limitsText() {
    const { largest_um: largest, end_um: end } = study.limits;
    return [largest !== null ? `largest change of the gap up to ${shown(largest)} µm` : null,
        end !== null ? `change at the end up to ${shown(end)} µm` : null].filter(Boolean).join(", ");
}

function windowsSection() {
    if (!limited) return null;
    return make("section", { id: "windows" }, make("h2", {}, "Best windows"),
        make("p", {}, `For each set, the table gives the largest block of neighbouring values that meets the limits: ${limitsText()}.`),
        table(["set", "window", "share of the range"], sets.map((set) => [words(set.name), set.window?.text ?? "–",
            set.window?.points ? `${fixed(100 * set.window.share_of_range, 0)} %` : "–"])));
}

// ---------------------------------------------------------------- families of curves

const mostCurves = 12;

function overTime(id, title, text, y, places, axis, values) {
    const shownPlaces = places.length <= mostCurves ? places : Array.from({ length: mostCurves }, (_, i) =>
        places[Math.round(i * (places.length - 1) / (mostCurves - 1))]);
    return lineChart({ id, title, text: shownPlaces.length < places.length ? `${text} ${mostCurves} of ${places.length} curves.` : text,
        x: ["time", "h"], y, series: shownPlaces.map((place, i) => ({ name: axis === null ? place.set.name
            : place.set.axes[axis].labels[place.steps[axis]], style: i, x: place.point.course.hours, y: values(place.point.course) })) });
}

function overAxis(id, title, text, unit, set, axis, places, lines) {
    const numbers = set.axes[axis].numbers;
    if (!numbers || places.length < 2) return null;
    const order = [...places].sort((a, b) => numbers[a.steps[axis]] - numbers[b.steps[axis]]);
    // Values over more than a decade are spaced by their logarithm.
    const wide = numbers.every((value) => value > 0) && Math.max(...numbers) > 10 * Math.min(...numbers);
    const x = order.map((place) => (wide ? Math.log10(numbers[place.steps[axis]]) : numbers[place.steps[axis]]));
    return lineChart({ id, title, text, x: [words(set.axes[axis].name), set.axes[axis].unit], y: unit, dots: true,
        xTicks: x.length <= 8 ? x : undefined, xFormat: wide ? (value) => shown(10 ** value) : undefined, series: lines.map(({ name, of, bold }) => ({ name, x, bold,
            y: order.map((place) => of(place.point.figures)) })) });
}

const otherSteps = (set, steps, free) => set.axes.map((axis, i) => (free.includes(i) ? null
    : `${words(axis.name)} ${axis.labels[steps[i]]}`)).filter(Boolean).join(", ");

/** Curves along one axis, with the others fixed; `state` holds the choice. */
function family(set, state) {
    const axis = set.axes.length ? state.axis : null;
    const places = set.places.filter((place) => place.point.course && place.steps.every((step, i) =>
        i === axis || step === state.steps[i]));
    const figured = places.filter((place) => place.point.figures);
    const held = axis === null ? "" : otherSteps(set, state.steps, [axis]);
    const at = held ? `With ${held}.` : "";
    const name = set.name, along = axis === null ? "" : ` by ${words(set.axes[axis].name)}`;
    const probe = probes[state.probe];
    const charts = [overTime(`${name}-drift`, `Change of the gap E_SW over time${along}`, `Above zero the gap opens. ${at}`,
        ["change", "µm"], places.filter((place) => place.point.course.E_SW), axis, (course) => course.E_SW)];
    const size = (value) => (value === undefined ? NaN : Math.abs(value));
    if (axis !== null) charts.push(overAxis(`${name}-limits`, `Size of the gap's change${along}`, at, ["size", "µm"], set, axis,
        figured, [{ name: "largest", bold: true, of: (f) => size(f.E_SW?.largest_um) },
            { name: "at the end", of: (f) => size(f.E_SW?.end_um) },
            ...(study.limits.largest_um !== null ? [{ name: "limit, largest", of: () => study.limits.largest_um }] : []),
            ...(study.limits.end_um !== null ? [{ name: "limit, end", of: () => study.limits.end_um }] : [])]));
    if (probe !== undefined) {
        charts.push(make("div", { class: "controls" }, select("Probe", `${name}-probe`, probes.map(words), state.probe,
            (index) => { state.probe = index; state.draw(`${name}-probe`); })));
        charts.push(overTime(`${name}-rise`, `Rise of ${words(probe)} over time${along}`, at, ["rise", "K"],
            places.filter((place) => place.point.course.rises[probe]), axis, (course) => course.rises[probe]));
        if (axis !== null) charts.push(overAxis(`${name}-rises`, `Rises at the end${along}`, at, ["rise", "K"], set, axis, figured,
            probes.map((entry) => ({ name: words(entry), of: (f) => f.rises_at_end_K[entry] ?? NaN }))));
    }
    return charts;
}

// ---------------------------------------------------------------- maps

const mapQuantities = [
    { name: "largest change of the gap [µm]", of: (f) => f.E_SW?.largest_um },
    { name: "change of the gap at the end [µm]", of: (f) => f.E_SW?.end_um },
    ...probes.map((probe) => ({ name: `rise of ${words(probe)} at the end [K]`, of: (f) => f.rises_at_end_K[probe] }))];

/** A map of two axes with numbers in cells: darker is larger, and the window has a thick frame. */
function map(set, state) {
    const [across, down] = state.map;
    const quantity = mapQuantities[state.quantity];
    const cells = set.axes[down].labels.map((_, row) => set.axes[across].labels.map((__, col) => {
        const steps = state.steps.map((step, i) => (i === across ? col : i === down ? row : step));
        return placeAt(set, steps);
    }));
    const value = (place) => (place?.point.figures ? quantity.of(place.point.figures) : undefined);
    const sizes = cells.flat().map(value).filter((v) => v !== undefined).map(Math.abs);
    const [least, most] = [Math.min(...sizes), Math.max(...sizes)];
    const cell = (place) => {
        const number = value(place);
        if (number === undefined) return make("td", { class: "empty" }, place ? stateWords[place.point.state] : "–");
        const share = most > least ? (Math.abs(number) - least) / (most - least) : 0;
        const element = make("td", { class: inWindow(place) ? "window" : "" }, fixed(number, 1, true));
        element.style.background = `rgb(${[235, 243, 250].map((light, c) => Math.round(light + share * ([8, 72, 122][c] - light))).join()})`;
        element.style.color = share > 0.45 ? "white" : "inherit";
        return element;
    };
    const [a, d] = [set.axes[across], set.axes[down]];
    const held = otherSteps(set, state.steps, state.map);
    const picks = [select("Map of", `${set.name}-map-of`, mapQuantities.map((q) => q.name), state.quantity, (index) => {
        state.quantity = index; state.draw(`${set.name}-map-of`); })];
    if (set.axes.length > 2) for (const [label, place] of [["across", 0], ["down", 1]])
        picks.push(select(label, `${set.name}-map-${label}`, set.axes.map((axis) => words(axis.name)), state.map[place], (index) => {
            if (index === state.map[1 - place]) state.map[1 - place] = state.map[place];
            state.map[place] = index;
            state.draw(`${set.name}-map-${label}`);
        }));
    return make("figure", { "data-map": set.name }, make("figcaption", {}, make("h3", {}, `Map of ${words(a.name)} and ${words(d.name)}`),
        make("p", {}, `${quantity.name[0].toUpperCase()}${quantity.name.slice(1)}; darker is larger.${held ? ` With ${held}.` : ""}`
            + (set.window?.points ? " Thick frames: the best window." : ""))),
    make("div", { class: "controls" }, picks),
    make("div", { class: "wide" }, make("table", { class: "map" },
        make("thead", {}, make("tr", {}, make("th", { scope: "col" }, `${words(d.name)} ↓  ${words(a.name)} →`), a.labels.map((label) =>
            make("th", { scope: "col" }, label)))),
        make("tbody", {}, cells.map((row, i) => make("tr", {}, make("th", { scope: "row" }, d.labels[i]), row.map(cell)))))));
}

function setSection(set, number) {
    const body = make("div");
    const state = { axis: 0, steps: set.axes.map(() => 0), probe: 0, quantity: 0, map: [0, 1] };
    state.draw = (focused) => {
        const controls = set.axes.length > 1 ? make("div", { class: "controls" },
            select("Curves by", `${set.name}-axis`, set.axes.map((axis) => words(axis.name)), state.axis, (index) => {
                state.axis = index; state.draw(`${set.name}-axis`); }),
            set.axes.map((axis, i) => (i === state.axis ? null : select(words(axis.name), `${set.name}-step-${i}`, axis.labels,
                state.steps[i], (index) => { state.steps[i] = index; state.draw(`${set.name}-step-${i}`); })))) : null;
        body.replaceChildren(...[set.axes.length > 1 ? map(set, state) : null, controls, ...family(set, state)].filter(Boolean));
        redrawFigures();
        if (focused) body.querySelector(`[data-control="${CSS.escape(focused)}"]`)?.focus();
    };
    state.draw();
    return make("section", { id: `set-${number}` }, make("h2", {}, set.axes.length ? `Set: ${words(set.name)}` : words(set.name)),
        make("ul", {}, set.axes.map((axis) => make("li", {}, make("strong", {}, words(axis.name)), `: ${axis.labels.join(", ")} `,
            make("span", { class: "quiet" }, `(${axis.keys.join(", ")})`)))), body);
}

// ---------------------------------------------------------------- table of points

function tableColumns() {
    const figure = (title, of, text, group, chosen = false) => ({ title, group, chosen, value: (place) =>
        (place.point.figures ? of(place.point.figures, place.point) : undefined), text });
    const one = (value) => fixed(value, 1, true);
    const axes = [...new Set(sets.flatMap((set) => set.axes.map((axis) => axis.name)))].map((name) => {
        const of = (place) => {
            const i = place.set.axes.findIndex((axis) => axis.name === name);
            return i < 0 ? undefined : { label: place.set.axes[i].labels[place.steps[i]],
                order: place.set.axes[i].numbers?.[place.steps[i]] ?? place.steps[i] };
        };
        return { title: words(name), group: "Axes", chosen: true, value: (place) => of(place)?.order,
            text: (_, place) => of(place)?.label ?? "–" };
    });
    const columns = [{ title: "set", group: "Axes", chosen: sets.length > 1, value: (place) => place.set.name, text: words }, ...axes,
        figure("largest [µm]", (f) => f.E_SW?.largest_um, one, "Gap", true),
        figure("largest after", (f) => f.E_SW?.largest_at_s, duration, "Gap"),
        figure("at the end [µm]", (f) => f.E_SW?.end_um, one, "Gap", true),
        figure("first hour [µm]", (f) => f.E_SW?.first_hour_change_um, one, "Gap"),
        figure("range [µm]", (f) => f.E_SW?.range_um, (value) => fixed(value, 1), "Gap"),
        figure("steady from", (f) => f.E_SW?.steady_from_s ?? undefined, duration, "Gap", true),
        figure("slope left to right [µm/m]", (_, point) => point.gaps?.parallelism?.left_to_right.final_um_per_m, one, "Slide and force"),
        figure("slope front to back [µm/m]", (_, point) => point.gaps?.parallelism?.front_to_back.final_um_per_m, one, "Slide and force"),
        figure("force change [kN]", (_, point) => point.gaps?.force?.largest_kN, one, "Slide and force"),
        ...probes.map((probe) => figure(`${words(probe)} [K]`, (f) => f.rises_at_end_K[probe], (value) => fixed(value, 2, true), "Rises")),
        figure("joint heat [W]", (f) => f.joint_heat_at_end_W ?? undefined, (value) => fixed(value, 0), "Heat and loads"),
        ...[...new Set(study.points.flatMap((point) => Object.keys(point.figures?.bearing_peak_forces_N ?? {})))].map((name) =>
            figure(`bearing ${name} [kN]`, (f) => f.bearing_peak_forces_N?.[name] / 1000, (value) => fixed(value, 2), "Heat and loads")),
        { title: "state", group: "Run", chosen: study.points.some((point) => !point.figures), value: (place) => place.point.state,
            text: (state) => stateWords[state] },
        { title: "folder", group: "Run", value: (place) => place.point.name, text: (name) => `points/${name}` },
        { title: "case hash", group: "Run", value: (place) => place.point.case_hash, text: (hash) => hash ?? "–" }];
    if (limited) columns.push({ title: "keeps limits", group: "Gap", chosen: true, value: (place) =>
        (place.point.figures ? Number(place.point.figures.keeps_limits) : undefined), text: (keeps) => (keeps ? "yes" : "no") });
    const places = sets.flatMap((set) => set.places);
    return columns.filter((column) => places.some((place) => column.value(place) !== undefined));
}

/** Rows sorted by value with its sign, ascending or descending; rows without a value come last. */
function sorted(places, column, descending) {
    const order = (a, b) => {
        const [x, y] = [column.value(a), column.value(b)];
        if (x === undefined || y === undefined) return (x === undefined) - (y === undefined);
        const by = typeof x === "number" ? x - y : String(x).localeCompare(String(y));
        return descending ? -by : by;
    };
    return [...places].sort(order);
}

function pointsSection() {
    const columns = tableColumns();
    const places = sets.flatMap((set) => set.places);
    let by = null, descending = false, only = 0;
    const holder = make("div", { class: "wide" });
    const draw = (focused) => {
        const chosen = columns.filter((column) => column.chosen);
        const rows = places.filter((place) => only === 0 || place.set.name === sets[only - 1].name);
        const sort = (column) => make("button", { class: "sort", type: "button", "data-sort": column.title, click: () => {
            descending = by === column && !descending;
            by = column;
            draw(column.title);
        } }, column.title, make("span", { "aria-hidden": "true" }, by === column ? (descending ? " ▼" : " ▲") : ""));
        holder.replaceChildren(make("table", { id: "points-table" },
            make("thead", {}, make("tr", {}, chosen.map((column) => make("th", { scope: "col", "aria-sort": by !== column ? "none"
                : descending ? "descending" : "ascending" }, sort(column))))),
            make("tbody", {}, (by ? sorted(rows, by, descending) : rows).map((place) => make("tr", { class: inWindow(place) ? "window" : "" },
                chosen.map((column, i) => make(i ? "td" : "th", i ? {} : { scope: "row" }, column.value(place) === undefined ? "–"
                    : column.text(column.value(place), place))))))));
        if (focused) holder.querySelector(`[data-sort="${CSS.escape(focused)}"]`)?.focus();
    };
    draw();
    const groups = [...new Set(columns.map((column) => column.group))];
    const boxes = groups.map((group) => make("fieldset", {}, make("legend", {}, group), columns.filter((column) => column.group === group)
        .map((column) => make("label", {}, make("input", { type: "checkbox", checked: column.chosen, "data-column": column.title,
            change: (event) => { column.chosen = event.target.checked; draw(); } }), column.title))));
    return make("section", { id: "points" }, make("h2", {}, "All points"),
        make("p", {}, "The table has one row for each point of each set. Click a heading to sort. Changes of the gap are relative to the start, at "
            + "bottom dead point; above zero the gap opens."),
        sets.length > 1 ? make("div", { class: "controls" }, select("Show", "only-set", ["all sets", ...sets.map((set) => words(set.name))], 0,
            (index) => { only = index; draw(); })) : null,
        make("details", { class: "columns" }, make("summary", {}, "Choose columns"), boxes), holder);
}

// ---------------------------------------------------------------- trust

function studyTrust() {
    const failed = study.points.filter((point) => point.reason || !point.figures);
    const warnings = study.warnings ?? [];
    return make("section", { id: "trust" }, make("h2", {}, "Warnings and assumptions"),
        failed.length ? make("div", {}, make("h3", {}, "Points without a result"), table(["point", "state", "reason"],
            failed.map((point) => [point.name, stateWords[point.state], point.reason ?? (point.interrupted ? "was stopped" : "–")]))) : null,
        warnings.length ? make("ul", { class: "warnings" }, warnings.map((text) => make("li", {}, text)))
            : make("p", {}, "The study gave no warnings."),
        make("p", {}, "Every point is a separate case with the same mesh; the folder points/ holds its files. “deadpoint report” with the folder of "
            + "a point writes its page, with the view in three dimensions, loads and assumptions."),
        data.left_out?.length ? make("p", {}, `Left out of the model: ${data.left_out.join(", ")}.`) : null);
}

function studyAbout() {
    const base = study.study;
    const hashes = [...new Set(study.points.map((point) => point.case_hash).filter(Boolean))];
    return make("section", { id: "about" }, make("h2", {}, "Units, citation, and how to repeat this"),
        make("p", {}, "Lengths in mm, changes in µm, temperatures in °C and their differences in K, heat in W, forces in kN."),
        table(["", ""], [["study", base.name], ["base case", base.base.replace(/^.*\//, "")],
            ["changed in all points", base.overrides.join(", ") || "nothing"], ["computed with", `deadpoint ${study.version}`],
            ["folder", data.folder], ["distinct points", String(study.points.length)],
            ["case hashes", hashes.length === 1 ? hashes[0] : `${hashes.length}, in the table of points`]]),
        make("p", {}, `Cite as: deadpoint ${study.version}, thermal drift of mechanical presses at bottom dead point; study `
            + `“${base.name}”, case hashes in the table of points. The file CITATION.cff of the program has the full entry.`));
}

function startStudy() {
    const contents = make("nav", { "aria-label": "Sections" });
    const sections = [windowsSection(), pointsSection(), ...sets.map(setSection), studyTrust(), studyAbout()].filter(Boolean);
    main.prepend(make("a", { class: "skip", href: "#points" }, "Skip to the results"));
    main.querySelector("h1").after(make("p", { class: "quiet" }, `A study of ${study.points.length} points, deadpoint ${study.version}, `
        + `machine ${data.machine || "–"}`), contents, study.study.note ? make("p", {}, study.study.note) : "", studyLead());
    main.append(...sections);
    contents.replaceChildren(make("ul", {}, sections.map((section) => make("li", {}, make("a", { href: `#${section.id}` },
        section.querySelector("h2").textContent)))));
    redrawFigures();
    document.body.dataset.ready = "true";
}
startStudy();
