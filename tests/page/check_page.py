#!/usr/bin/env python3
"""Looks at the pages of two results in a browser, as a reader would: check_page.py DEADPOINT SOURCE [ROM [PICTURES]].

Checks that nothing goes wrong on the console, that no request leaves the page, that every chart shows the data of the
result files, that the three-dimensional view is not blank and follows time, turning, cutting and hiding, that the keys
work, that the printed page is complete, and that it fits a phone. The pages of an
optimum and of a plan need ROM, a reduced model of the starter press. With a folder for PICTURES it leaves screenshots there.
"""

import base64
import csv
import json
import math
import os
import struct
import subprocess
import sys
import tempfile

import browser

failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what, flush=True)


def near(a, b, tolerance, what):
    check(abs(a - b) <= tolerance, f"{what}: {a} instead of {b}")


def read_csv(path):
    with open(path) as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}


def number(text):
    """A number as the page shows it."""
    return float(text.replace("−", "-").replace("+", "").split(" ")[0])


def unpacked(array):
    """Values of an array of view.json."""
    raw = base64.b64decode(array["data"])
    return [array["low"] + array["step"] * n for n in struct.unpack(f"<{len(raw) // 2}H", raw)]


LINES = """[...document.querySelectorAll("figure[data-chart]")].map((figure) => ({
    id: figure.dataset.chart, width: figure.getBoundingClientRect().width,
    lines: [...figure.querySelectorAll("svg g.series path")].map((path) => path.getAttribute("d")).filter(Boolean).length,
    drawn: figure.querySelectorAll(".drawing svg path, .drawing svg rect, .drawing svg line").length,
    rows: [...figure.querySelectorAll("details tbody tr")].map((row) => [...row.cells].map((cell) => cell.textContent)),
    heading: figure.querySelector("h3")?.textContent ?? "" }))"""

# Share of pixels that are not white, and a sum that changes with the picture.
PIXELS = """(() => {
    const view = document.querySelector(".stage canvas");
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [view.width, view.height];
    const context = copy.getContext("2d");
    context.drawImage(view, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let shown = 0, sum = 0;
    const colours = new Set();
    for (let i = 0; i < data.length; i += 4) {
        if (data[i] < 250 || data[i + 1] < 250 || data[i + 2] < 250) ++shown;
        sum = (sum * 31 + data[i] + 256 * data[i + 1] + 65536 * data[i + 2]) % 4294967291;
        colours.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
    }
    return { shown: shown / (copy.width * copy.height), sum, colours: colours.size };
})()"""


def set_control(page, name, value):
    page.run(f"""(() => {{ const control = document.querySelector('[data-control="{name}"]');
        if (control.type === "checkbox") {{ control.checked = {json.dumps(value)}; }} else control.value = {json.dumps(value)};
        control.dispatchEvent(new Event("input", {{ bubbles: true }}));
        control.dispatchEvent(new Event("change", {{ bubbles: true }})); }})()""")
    page.settle()


def check_charts(page, folder, width):
    history = read_csv(folder + "/history.csv")
    charts = {chart["id"]: chart for chart in page.run(LINES)}
    probes = [name for name in history if name.endswith("[degC]") and " temperature " not in name]
    joints = [name for name in history if name.endswith(" temperature [degC]")]
    heats = [name for name in history if name.endswith(" heat [W]") and max(history[name]) > 0]
    dimensions = [name for name in history if name.endswith("[um]")]
    wanted = {"probes": len(probes), "joints": min(10, len(joints)), "joint-heat": min(8, len(heats)), "balance": 4,
              "drift": len(dimensions), "slide": 1, "joint-forces": 7, "bearings": 6,
              # Half a press: a corner in front and one at the back, and the gap; left and right are alike.
              "corners": 3, "slopes": 1, "clearance-changes": 8}
    for name, count in wanted.items():
        check(name in charts, f"{width} px: chart '{name}' is missing")
        if name in charts:
            near(charts[name]["lines"], count, 0, f"{width} px: lines in '{name}'")
            near(len(charts[name]["rows"]), count, 0, f"{width} px: rows of figures in '{name}'")
    for name in ("waterfall-end", "causes-end", "flow", "orders", "linkage"):
        check(charts.get(name, {}).get("drawn", 0) > 5, f"{width} px: chart '{name}' is missing or empty")
    for chart in charts.values():
        check(chart["heading"] != "", f"chart '{chart['id']}' has no heading")
        check(chart["width"] <= width, f"{width} px: chart '{chart['id']}' is too wide")
    for row in charts["drift"]["rows"]:
        values = history[f"{row[0]} [um]"]
        near(number(row[4]), values[-1], 5e-4 * abs(values[-1]) + 1e-3, f"end of {row[0]}")
    for row, name in zip(charts["probes"]["rows"], probes):
        rise = history[name][-1] - history[name][0]
        near(number(row[4]), rise, 5e-4 * abs(rise) + 1e-3, f"rise of {name}")
    check_axis(page, history)
    check_waterfall(page, history, "waterfall-end")
    check_causes(page, folder, history)
    check_gaps(page, charts, read_csv(folder + "/gaps.csv"))


def check_gaps(page, charts, gaps):
    """Corners and clearances of the page are those of the file."""
    for row, name in zip(charts["corners"]["rows"], ("gap front left [um]", "gap back left [um]")):
        near(number(row[4]), gaps[name][-1], 5e-4 * abs(gaps[name][-1]) + 1e-3, f"end of {name}")
        check(gaps[name] == gaps[name.replace("left", "right")], f"{name} has no mirror image")
    changes = {name: values for name, values in gaps.items() if name.startswith("clearance ")}
    rows = page.run("""[...document.querySelectorAll("#clearances > .wide tbody tr")].map((row) =>
        [...row.cells].map((cell) => cell.textContent))""")
    near(len(rows), len(changes), 0, "rows of clearances")
    for row in rows:
        column = [values for name, values in changes.items() if name[len("clearance "):-len(" [um]")].replace("_", " ") == row[0]]
        near(len(column), 1, 0, f"columns of the clearance '{row[0]}'")
        near(number(row[2]), column[0][-1], 0.051, f"clearance '{row[0]}' at the end")


def check_axis(page, history):
    """The drawn line of E_SW ends where the axis says its value is."""
    ends, ticks = page.run("""(() => {
        const drawing = document.querySelector('figure[data-chart="drift"] .drawing > svg');
        const place = (text) => text.match(/-?\\d[\\d.]*/g).map(Number);
        const ends = [...drawing.querySelectorAll("g.series path")].map((path) => place(path.getAttribute("d")).slice(-1)[0]);
        const ticks = [...drawing.querySelectorAll('g[aria-label="y-axis tick label"] text')]
            .map((text) => [place(text.getAttribute("transform"))[1], text.textContent]);
        return [ends, ticks]; })()""")
    (y0, low), (y1, high) = [(y, number(text)) for y, text in (ticks[0], ticks[-1])]
    names = [name for name in history if name.endswith("[um]")]
    for name, end in zip(names, ends):
        near(low + (end - y0) / (y1 - y0) * (high - low), history[name][-1], 0.01 * (high - low), f"line of {name}")


def waterfall_steps(page, chart):
    text = page.run(f"""document.querySelector('figure[data-chart="{chart}"] svg').getAttribute("aria-label")""")
    return [piece.rsplit(" ", 1) for piece in text.split(": ", 1)[1].rsplit(" ", 1)[0].split(", ")]


def check_waterfall(page, history, chart):
    steps = waterfall_steps(page, chart)
    near(number(steps[-1][1]), history["E_SW [um]"][-1], 0.15, f"total of {chart}")
    near(sum(number(value) for _, value in steps[:-1]), number(steps[-1][1]), 0.06 * len(steps), f"sum of {chart}")


def check_causes(page, folder, history):
    """The strongest cause at the end is that of causes.csv."""
    check_waterfall(page, history, "causes-end")
    with open(folder + "/causes.csv") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))[1:]
    strongest = max(rows, key=lambda row: abs(float(row[-1])))
    shown = waterfall_steps(page, "causes-end")[0]
    check(strongest[1].replace("_", " ") in shown[0], f"the strongest cause is {strongest}, the page says {shown}")
    near(number(shown[1]), float(strongest[-1]), 0.051, "value of the strongest cause")
    near(sum(float(row[-1]) for row in rows), history["E_SW [um]"][-1], 1e-3, "sum of causes.csv")


def check_view(page, folder):
    with open(folder + "/view.json") as file:
        view = json.load(file)
    first = page.run(PIXELS)
    check(first["shown"] > 0.05, f"the view is blank: {first}")
    check(first["colours"] > 20, f"the view has no colours: {first}")
    # The page decodes as Python does.
    base, mode = unpacked(view["temperature_K"]["base"]), unpacked(view["temperature_K"]["modes"][0])
    modes = [unpacked(entry) for entry in view["temperature_K"]["modes"]]
    ours = [base[i] + sum(c[-1] * m[i] for c, m in zip(view["coefficients"], modes)) for i in range(0, len(mode), 97)]
    theirs = page.run("(() => { const f = new Fields(runs[0].view); const t = f.at(f.temperature, f.end);"
                      " return Array.from(t).filter((_, i) => i % 97 === 0); })()")
    near(max(abs(a - b) for a, b in zip(ours, theirs)), 0, 1e-3, "temperatures at vertices, largest difference")
    check(sum(part["triangles"] for part in view["parts"]) <= 30000, "too many triangles")
    check(view["error_of_modes_K"] <= 0.005 * view["largest_rise_K"], "the modes are not good enough")

    def changes(action, what):
        before = page.run(PIXELS)["sum"]
        action()
        page.settle()
        check(page.run(PIXELS)["sum"] != before, f"the view does not change by {what}")

    changes(lambda: set_control(page, "time", 100), "the time slider")
    changes(lambda: set_control(page, "magnification", 20), "the deformation's slider")
    changes(lambda: set_control(page, "quantity", "up"), "the choice of colours")
    changes(lambda: set_control(page, "slice", "z"), "cutting")
    changes(lambda: set_control(page, "slice", ""), "closing the cut")
    changes(lambda: set_control(page, "crank", 90), "the crank")
    changes(lambda: set_control(page, "Mirrored half", False), "taking the mirrored half away")
    page.run("document.querySelector('.stage canvas').focus()")
    for key in ("ArrowLeft", "ArrowUp", "+", "Home"):
        changes(lambda pressed=key: page.key(pressed), f"the key {key}")
    changes(lambda: [page.key(".") for _ in range(10)], "stepping in time")
    # The wheel of time runs by itself, also in calm steps.
    for wish in ("no-preference", "reduce"):
        page.prefer(prefers_reduced_motion=wish)
        set_control(page, "time", 0)
        page.run("document.querySelector('.stage canvas').focus()")
        page.key(" ")
        page.until("Number(document.querySelector('[data-control=time]').value) > 20")
        page.key(" ")
    page.prefer(prefers_reduced_motion="no-preference")
    check_picking(page, view)
    for state, least, most in ((False, -1, 1e-9), (True, 0.01, 1)):
        page.run(f"""document.querySelectorAll("[data-body]").forEach((box) => {{ box.checked = {json.dumps(state)};
            box.dispatchEvent(new Event("change")); }})""")
        page.settle()
        share = page.run(PIXELS)["shown"]
        check(least <= share <= most, f"parts {'shown' if state else 'hidden'}: {share} of the view is not white")


def check_picking(page, view):
    # The middle of the view from the right shows a part; that of the first view looks through the opening of the press.
    page.run("[...document.querySelectorAll('button')].find((b) => b.textContent === 'From the right').click()")
    set_control(page, "crank", 0)
    set_control(page, "time", 1000)
    page.key("p")
    page.settle()
    by_key = page.run("document.querySelector('.picked').textContent")
    check("°C" in by_key and " mm after " in by_key, f"the key P tells nothing: '{by_key}'")
    rise = number(by_key.split("rise ")[1].split(" K")[0])
    check(-1 <= rise <= view["largest_rise_K"] * 1.01, f"a picked rise of {rise} K cannot be")
    page.run("document.querySelector('.stage').scrollIntoView({ behavior: 'instant' })")
    box = page.run("(() => { const b = document.querySelector('.stage canvas').getBoundingClientRect();"
                   " return [b.x + b.width / 2, b.y + b.height / 2]; })()")
    page.click(*box)
    page.settle()
    by_mouse = page.run("document.querySelector('.picked').textContent")
    check(by_mouse.split(" at ")[0] == by_key.split(" at ")[0], f"a click tells '{by_mouse}', the key '{by_key}'")
    near(page.run("document.querySelectorAll('figure[data-chart=picked] g.series path').length"), 1, 0,
         "lines of the picked point")


def check_structure(page):
    levels = page.run("[...document.querySelectorAll('h1,h2,h3,h4')].map((h) => [Number(h.tagName[1]), h.textContent])")
    check([level for level, _ in levels].count(1) == 1, "there is not exactly one h1")
    for (before, _), (level, text) in zip(levels, levels[1:]):
        check(level <= before + 1, f"the heading '{text}' skips a level")
    sections = [text for level, text in levels if level == 2]
    for word in ("three dimensions", "gap", "parallelism", "Clearances", "Temperatures", "Heat", "Loads", "published", "Warnings", "citation"):
        check(any(word in text for text in sections), f"no section about '{word}'")
    unnamed = page.run("""[...document.querySelectorAll("input, select, button, canvas")].filter((control) =>
        !control.getAttribute("aria-label") && !control.closest("label") && !control.textContent.trim()).length""")
    near(unnamed, 0, 0, "controls without a name")
    check(page.run("document.documentElement.lang") == "en", "the page's language is not stated")
    text = page.run("document.body.innerText")
    for word in ("Predicting no rise at all", "Cite as", "case hash", "energy balance"):
        check(word in text, f"the page does not say '{word}'")


def check_print(page, pictures):
    page.size(1280, 900)
    page.settle()
    with tempfile.TemporaryDirectory() as folder:
        page.pdf(folder + "/page.pdf")
        check(os.path.getsize(folder + "/page.pdf") > 50000, "the printed page is too small to be complete")
    page.call("Emulation.setEmulatedMedia", media="print")
    page.run("dispatchEvent(new Event('beforeprint'))")
    page.settle()
    state = page.run("""({ still: getComputedStyle(document.querySelector(".still")).display,
        canvas: getComputedStyle(document.querySelector(".stage canvas")).display,
        size: document.querySelector(".still").naturalWidth,
        controls: [...document.querySelectorAll(".controls, button")].filter((e) => e.offsetParent).length,
        charts: [...document.querySelectorAll("figure[data-chart] .drawing > svg")].map((s) => Number(s.getAttribute("width"))) })""")
    check(state["still"] == "block" and state["size"] > 100, f"print: no still of the view: {state}")
    check(state["canvas"] == "none", "print: the live view is not replaced")
    near(state["controls"], 0, 0, "print: visible controls")
    check(len(state["charts"]) >= 12 and max(state["charts"]) <= 680, f"print: charts {state['charts']}")
    if pictures:
        page.size(720, 1000)
        page.settle()
        page.picture(pictures + "/print.png")
    page.call("Emulation.setEmulatedMedia", media="")
    page.run("dispatchEvent(new Event('afterprint'))")


def check_both(page, path, count):
    page.size(1280, 900)
    page.open(path)
    page.settle()
    near(page.run("document.querySelectorAll('#side-by-side > .wide thead th').length"), count + 1, 0, "columns side by side")
    check(page.run("document.querySelectorAll('#side-by-side > .wide tbody tr').length") > 8, "too few rows side by side")
    options = page.run("[...document.querySelector('[data-control=compare]').options].map((o) => o.value)")
    for option in options[:3]:
        set_control(page, "compare", option)
        check(page.run("document.querySelectorAll('figure[data-chart=compared] g.series path').length") >= 1,
              f"nothing to compare for {option!r}")
    before = page.run("document.querySelector('#detail').innerText")
    page.run("""(() => { const choose = document.querySelector('[data-control="run"]'); choose.selectedIndex = 1;
        choose.dispatchEvent(new Event("change")); })()""")
    page.settle()
    check(page.run("document.querySelector('#detail').innerText") != before, "the second result is not shown in full")
    check(page.run(PIXELS)["shown"] > 0.02, "the view of the second result is blank")


STUDY = """format = 1
name = "two speeds, two forces"
base = "SOURCE/cases/starter/case.toml"
set = ["operation.0.duration=20 min", "chain.press_stiffness=1e9 N/m"]
[limits]
largest = "LIMIT um"
[[sets]]
name = "crossed"
[[sets.axes]]
key = "operation.0.speed"
values = ["30 rpm", "60 rpm", "90 rpm"]
[[sets.axes]]
key = "operation.0.force"
values = ["0 kN", "100 kN"]
[[sets]]
name = "air"
[[sets.axes]]
key = "machine.ambient"
values = ["20 degC", "25 degC"]
"""


MATTERS = """
format = 1
name = "what matters"
base = "SOURCE/tests/data/cli/two-blocks.toml"
[sensitivity]
points = 16
times = ["2 min"]
[[sensitivity.parameters]]
name = "room"
keys = ["machine.ambient"]
shift = "5 K"
[[sensitivity.parameters]]
name = "air"
keys = ["surfaces.air.film.coefficient"]
factor = 2
"""


WARM = """
format = 1
name = "warm soon"
base = "SOURCE/cases/starter/case.toml"
set = ["operation.0.duration=3 h"]
[optimise]
objective = "drift"
from = "30 min"
starts = 1
[optimise.speed_profile]
ends = ["0.5 h", "1 h"]
from = "30 rpm"
to = "90 rpm"
[[optimise.limits]]
output = "slide"
most = "60 degC"
"""


PLAN = """
format = 1
name = "what to measure"
[[parameters]]
name = "pins"
keys = ["friction.pins.*_part"]
factor = 2
[[parameters]]
name = "films"
keys = ["surfaces.air_*.film.coefficient"]
factor = 2
[[runs]]
name = "warm-up"
measure = ["slide"]
[[sensors]]
columns = ["slide", "upright", "bearing_front"]
noise = "0.2 K"
[[sensors]]
columns = ["E_SW"]
noise = "1 um"
"""


def read_study(folder):
    with open(folder + "/sweep.csv") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return [dict(zip(rows[0], row)) for row in rows[1:]]


def cells(page, selector):
    return page.run(f"""[...document.querySelectorAll({json.dumps(selector)})].map((row) =>
        [...row.cells].map((cell) => cell.textContent))""")


def open_report(page, folder, width, what):
    """Opens the page of a folder in a window or on a phone, which it fills."""
    page.size(width, 900, phone=width < 500)
    page.open(folder + "/report.html")
    page.settle()
    near(page.run("document.documentElement.scrollWidth"), width, 0, f"{what}, {width} px: width of the page")


def check_study(page, folder, width, pictures):
    open_report(page, folder, width, "study")
    rows = read_study(folder)
    charts = {chart["id"]: chart for chart in page.run(LINES)}
    for name, count in {"crossed-drift": 3, "crossed-limits": 3, "crossed-rise": 3, "crossed-rises": 3, "air-drift": 2,
                        "air-limits": 3, "air-rise": 2, "air-rises": 3}.items():
        check(name in charts, f"study, {width} px: chart '{name}' is missing")
        near(charts.get(name, {}).get("lines", 0), count, 0, f"study, {width} px: lines in '{name}'")
    for row, speed in zip(charts["crossed-drift"]["rows"], ("30 rpm", "60 rpm", "90 rpm")):
        stated = [entry for entry in rows if entry["speed"] == speed and entry["force"] == "0 kN"]
        check(row[0] == speed, f"study: the curve of {speed} is called {row[0]}")
        near(number(row[4]), float(stated[0]["E_SW at end [um]"]), 5e-3, f"study: end of the curve of {speed}")
    grid = cells(page, "figure[data-map=crossed] tbody tr")
    for line, force in zip(grid, ("0 kN", "100 kN")):
        for cell, speed in zip(line[1:], ("30 rpm", "60 rpm", "90 rpm")):
            stated = [entry for entry in rows if entry["speed"] == speed and entry["force"] == force]
            near(number(cell), float(stated[0]["largest E_SW [um]"]), 0.051, f"study: map at {speed}, {force}")
    framed = page.run("document.querySelectorAll('figure[data-map=crossed] td.window').length")
    near(framed, sum(entry["in window"] == "yes" for entry in rows if entry["set"] == "crossed"), 0, "study: cells in the window")
    check(0 < framed < 6, f"study: {framed} cells in the window say nothing")
    if pictures:
        page.picture(f"{pictures}/study-{width}.png")


def check_study_table(page, folder):
    """The table has a row for each place; headings sort by key, columns come and go."""
    rows = read_study(folder)
    near(len(cells(page, "#points-table tbody tr")), len(rows), 0, "study: rows of the table")
    largest = sorted(float(row["largest E_SW [um]"]) for row in rows)
    for times, wanted, state in ((1, largest, "ascending"), (2, largest[::-1], "descending")):
        page.run("document.querySelector('[data-sort=\"largest [µm]\"]').focus()")
        for kind in ("keyDown", "keyUp"):
            page.call("Input.dispatchKeyEvent", type=kind, key="Enter", code="Enter", windowsVirtualKeyCode=13, text="\r")
        page.settle()
        titles = page.run("[...document.querySelectorAll('#points-table th[scope=col]')].map((t) => [t.textContent, t.ariaSort])")
        place = [title.startswith("largest [") for title, _ in titles].index(True)
        check(titles[place][1] == state, f"study: sorted {titles[place][1]} instead of {state}")
        shown = [number(row[place]) for row in cells(page, "#points-table tbody tr")]
        near(max(abs(a - b) for a, b in zip(shown, wanted)), 0, 0.051, f"study: order after {times} key presses")
        check(page.run("document.activeElement.dataset.sort") == "largest [µm]", "study: sorting loses the focus")
    before = len(titles)
    page.run("""(() => { const box = document.querySelector('[data-column="force change [kN]"]');
        box.checked = true; box.dispatchEvent(new Event("change")); })()""")
    now = page.run("[...document.querySelectorAll('#points-table th[scope=col]')].map((t) => t.textContent)")
    near(len(now), before + 1, 0, "study: columns after one more is chosen")
    set_control(page, "only-set", "air")
    near(len(cells(page, "#points-table tbody tr")), 2, 0, "study: rows of one set")
    set_control(page, "crossed-axis", "force")
    near(len([1 for chart in page.run(LINES) if chart["id"] == "crossed-drift" and chart["lines"] == 2]), 1, 0,
         "study: curves along the other axis")
    check(page.run("document.activeElement.dataset.control") == "crossed-axis", "study: choosing loses the focus")
    levels = page.run("[...document.querySelectorAll('h1,h2,h3')].map((h) => Number(h.tagName[1]))")
    check(levels.count(1) == 1 and all(b <= a + 1 for a, b in zip(levels, levels[1:])), f"study: headings {levels}")
    text = page.run("document.body.innerText")
    for word in ("Cite as", "case hash", "Best windows", "Warnings", "Left out"):
        check(word in text, f"the study's page does not say '{word}'")
    page.call("Emulation.setEmulatedMedia", media="print")
    page.run("dispatchEvent(new Event('beforeprint'))")
    page.settle()
    near(page.run("[...document.querySelectorAll('.controls, .columns, nav')].filter((e) => e.offsetParent).length"), 0, 0,
         "study, print: visible controls")
    near(page.run("[...document.querySelectorAll('#points-table th button')].filter((e) => e.offsetParent).length"), len(now), 0,
         "study, print: headings")
    page.call("Emulation.setEmulatedMedia", media="")
    page.run("dispatchEvent(new Event('afterprint'))")


def check_sensitivity(page, folder, width):
    """Bars, curves and table of a study of sensitivity against its file."""
    open_report(page, folder, width, "sensitivity")
    with open(folder + "/sensitivity.json") as file:
        found = json.load(file)
    output = page.run("document.querySelector('[data-control=output]').selectedOptions[0].textContent")
    figures = [figure for figure in found["figures"] if figure["output"] == output]
    ends = next(figure for figure in figures if figure["figure"] == "end")["parameters"]
    ranked = sorted(ends, key=lambda name: -ends[name]["total"][0])
    bars = page.run("""[...document.querySelectorAll('[data-chart^="bars-"]')].map((chart) => ({
        names: [...chart.querySelectorAll("svg text[font-weight], svg text")].map((text) => text.textContent),
        widths: [...chart.querySelectorAll("rect.bar")].map((bar) => Number(bar.getAttribute("width"))) }))""")
    near(len(bars), len(figures), 0, f"sensitivity, {width} px: charts of bars")
    widths = bars[[figure["figure"] for figure in figures].index("end")]["widths"]
    for place, name in enumerate(ranked[1:], 1):
        near(widths[place] / widths[0], max(0, ends[name]["total"][0]) / ends[ranked[0]]["total"][0], 0.02,
             f"sensitivity, {width} px: bar of {name}")
    charts = {chart["id"]: chart for chart in page.run(LINES)}
    near(charts["course-" + output]["lines"], len(ends), 0, f"sensitivity, {width} px: curves over time")
    near(len(cells(page, "#parameters tbody tr")), len(ends), 0, f"sensitivity, {width} px: rows of the table")


def check_optimum(page, folder, width):
    """Curves, steps and table of a search for an optimum against its file."""
    open_report(page, folder, width, "optimum")
    with open(folder + "/optimise.json") as file:
        found = json.load(file)
    charts = {chart["id"]: chart for chart in page.run(LINES)}
    for name in ("gap", "rate", "profile"):
        near(charts.get(name, {}).get("lines", 0), 2, 0, f"optimum, {width} px: curves of '{name}'")
    for row, one in zip(cells(page, "#variables tbody tr"), found["variables"]):
        near(number(row[2]), one["optimum"], 5e-4 * abs(one["optimum"]), f"optimum, {width} px: {one['name']}")
    rows = {row[0]: row for row in cells(page, "#figures tbody tr")}
    largest = next(row for name, row in rows.items() if "largest" in name)
    near(number(largest[2]), found["promised"]["largest_change_um"], 0.006, f"optimum, {width} px: largest change")


def check_plan(page, folder, width):
    """Bars and tables of a planned calibration against its file."""
    open_report(page, folder, width, "plan")
    with open(folder + "/plan.json") as file:
        found = json.load(file)
    bars = {chart: page.run(f"[...document.querySelectorAll('[data-chart={chart}] rect.bar')].map((bar) => Number(bar.getAttribute('width')))")
            for chart in ("left", "gains")}
    near(len(bars["left"]), len(found["parameters"]), 0, f"plan, {width} px: bars of unknowns")
    left = [math.sqrt(1 - one["shrinkage"]) for one in found["parameters"]]
    gains = [one["information_nat"] for one in found["candidates"]]
    # Bars are at least a pixel wide.
    near(bars["left"][1] / bars["left"][0], left[1] / left[0], 0.03 * left[1] / left[0], f"plan, {width} px: bars of unknowns")
    near(bars["gains"][1] / bars["gains"][0], gains[1] / gains[0], 0.03, f"plan, {width} px: bars of candidates")
    for row, one in zip(cells(page, "#unknowns tbody tr"), found["parameters"]):
        near(number(row[4]), 100 * one["shrinkage"], 0.51, f"plan, {width} px: share of {one['name']}")
    near(len(cells(page, "#candidates tbody tr")), len(gains), 0, f"plan, {width} px: rows of candidates")


SKETCH = """(() => { const scene = checked.scene;
    const colours = {};
    for (const part of scene.parts) part.runs.forEach((run, i) => { const colour = "#" + part.skin[i].color.getHexString();
        (colours[part.name] ??= {})[colour] = ((colours[part.name] ?? {})[colour] ?? 0) + run.count; });
    return { colours, joints: [...scene.jointLines].map(([name, ends]) => [name, ends]), dimensions: scene.dimensions,
        labels: [...document.querySelectorAll(".label.wrong")].map((label) => label.textContent) }; })()"""


def sketched(deadpoint, source, folder, name, *overrides):
    """The page of `check --view` of the small press with some values changed."""
    file = f"{folder}/{name}.html"
    sets = [word for value in overrides for word in ("--set", value)]
    done = subprocess.run([deadpoint, "check", "-q", "--view", "-o", file, "--size", "2", *sets,
                           source + "/cases/slider-crank/case.toml"], capture_output=True, text=True,
                          stdin=subprocess.DEVNULL, env={**os.environ, "BROWSER": "true"})
    check(done.returncode == (2 if overrides else 0), f"check --view {name} ends with {done.returncode}: {done.stderr}")
    return file


def check_views(page):
    """The buttons stand where their names say. The small press has its front at z < 0, with x to the left."""
    towards = "checked.scene.camera.position.clone().sub(checked.scene.controls.target).normalize().toArray()"
    on_screen = ("[checked.scene.low, checked.scene.high].map(([x]) => checked.scene.project([x, -0.5, 0]))"
                 ".map(([x]) => x)")
    for name, direction in (("front", [0, 0, -1]), ("left", [1, 0, 0]), ("right", [-1, 0, 0]), ("back", [0, 0, 1]),
                            ("above", [0, 1, 0])):
        page.run(f"[...document.querySelectorAll('button')].find((b) => b.textContent === 'From {'the ' if name != 'above' else ''}{name}').click()")
        for k, value in enumerate(page.run(towards)):
            near(value, direction[k], 0.01, f"view from {name}, component {k}")
        if name in ("front", "back"):
            low, high = page.run(on_screen)  # of x
            check((low > high) == (name == "front"), f"x points the wrong way as seen from the {name}: {low}, {high}")


def check_sketch(page, deadpoint, source, folder, pictures):
    """The picture before solving: of a sound case, and of one with a mistake in a joint, a probe and a part."""
    red = "#d7191c"
    for width, height in ((360, 740), (1280, 900)):
        page.size(width, height, phone=width < 500)
        page.open(sketched(deadpoint, source, folder, f"sound-{width}"))
        page.settle()
        near(page.run("document.documentElement.scrollWidth"), width, 0, f"sketch, {width} px: width of the page")
    sound = page.run(SKETCH)
    check(page.run(PIXELS)["shown"] > 0.05, "the sketch is blank")
    check(not sound["labels"] and red not in str(sound["colours"]), "a sound case stands red")
    near(len(sound["colours"]), 13, 0, "parts of the sketch")
    check("#009e73" in sound["colours"]["connecting_rod"], "the faces of joints are not coloured")
    lengths = {entry["name"]: entry["length"] for entry in sound["dimensions"]}
    near(lengths["E_BG"], 1.52, 1e-4, "the height of the crankshaft above ground")  # case.toml: feet at y = -1520 mm
    near(lengths["E_WG"] + lengths["E_SW"] + lengths["E_CS"], lengths["E_BG"], 1e-4, "the sum of the chain")
    ends = dict(sound["joints"])["wrist_pin"]
    near(ends[0][1], -0.38, 1e-6, "the height of the wrist pin")
    check(ends[0][2] < -0.05 and ends[1][2] > 0.05, f"the axis of the wrist pin does not pass the rod: {ends}")
    for control, value in (("spread", 10), ("See through", True), ("Faces of joints", False), ("slice", "z")):
        before = page.run(PIXELS)["sum"]
        set_control(page, control, value)
        page.settle()
        check(page.run(PIXELS)["sum"] != before, f"the sketch does not change by '{control}'")
    check_views(page)
    page.open(sketched(deadpoint, source, folder, "joint", "joints.crank_pin.interfaces.0.diameter=140 mm"))
    wrong = page.run(SKETCH)
    check(len(wrong["labels"]) == 1 and "140 mm" in wrong["labels"][0], f"labels of the wrong joint: {wrong['labels']}")
    near(page.run("document.querySelectorAll('.findings li.error').length"), 2, 0, "findings of the wrong joint")
    near(page.run("sketch.sought.length"), 2, 0, "faces sought in vain")
    before = page.run("checked.scene.camera.position.toArray()")
    page.run("document.querySelector('.findings button').click()")
    page.settle()
    near(page.run("checked.scene.controls.target.y"), -0.03, 1e-4, "the height of what is looked at")
    check(page.run("checked.scene.camera.position.toArray()") != before, "a click on a finding looks nowhere")
    if pictures:
        page.picture(pictures + "/sketch-joint.png")
    page.open(sketched(deadpoint, source, folder, "part", 'parts.slide.shapes.0.x=["10 mm", "0 mm"]',
                       "surfaces.table_face.position=-1 m"))
    wrong = page.run(SKETCH)
    check("slide" not in wrong["colours"] and len(wrong["colours"]) == 12, "the other parts are not drawn")
    check("slide" in page.run("document.querySelector('#findings').innerText"), "the wrong part is not named")


def check_without_scripts(page, path, words):
    page.call("Emulation.setScriptExecutionDisabled", value=True)
    page.call("Page.navigate", url="file://" + os.path.abspath(path))
    page.until("document.readyState === 'complete'")
    text = page.run("document.body.innerText")
    for word in words:
        check(word in text, f"without scripts {os.path.basename(os.path.dirname(path))} does not show '{word}'")
    page.call("Emulation.setScriptExecutionDisabled", value=False)


def check_pictures(folder):
    """The pictures for papers are PNG files of the stated size, and not white all over."""
    for pose in ("oblique", "front", "side", "cut"):
        with open(f"{folder}/machine-{pose}.png", "rb") as file:
            data = file.read()
        check(data[:8] == b"\x89PNG\r\n\x1a\n", f"picture '{pose}' is no PNG")
        check(struct.unpack(">II", data[16:24]) == (1600, 1200), f"picture '{pose}' has a wrong size")
        check(len(data) > 9000, f"picture '{pose}' is blank ({len(data)} bytes)")


def compute(deadpoint, source, folder, rom):
    """A coarse press with all that a page can show, a plain case to set beside it, and studies on a reduced press."""
    press, blocks, both = folder + "/press", folder + "/blocks", folder + "/both.html"
    with open(folder + "/study.toml", "w") as file:
        file.write(STUDY.replace("SOURCE", os.path.abspath(source)).replace("LIMIT", "25"))
    with open(folder + "/matters.toml", "w") as file:
        file.write(MATTERS.replace("SOURCE", os.path.abspath(source)))
    for name, text in (("warm", WARM), ("plan", PLAN)):
        with open(f"{folder}/{name}.toml", "w") as file:
            file.write(text.replace("SOURCE", os.path.abspath(source)))
    reduced = [] if rom is None else [
            ["optimise", folder + "/warm.toml", "--reduced", rom, "--no-full-run", "-o", folder + "/warm", "--quiet"],
            ["calibrate", source + "/cases/starter/case.toml", folder + "/plan.toml", "--reduced", rom, "--plan", "-o",
             folder + "/plan", "--quiet"]]
    for arguments in (
            ["run", source + "/cases/jl75g-60/case.toml", "-o", press, "--size", "5", "--quiet", "--set",
             "operation.0.duration=30 min"],
            ["run", source + "/tests/data/cli/two-blocks.toml", "-o", blocks, "--quiet"],
            ["report", blocks, "--pictures", folder + "/pictures"],
            ["report", press, blocks, "-o", both],
            ["sweep", folder + "/study.toml", "-o", folder + "/study", "--size", "3", "--quiet"],
            ["reduce", source + "/tests/data/cli/two-blocks.toml", "-o", folder + "/blocks.rom", "--quiet"],
            ["sensitivity", folder + "/matters.toml", "--reduced", folder + "/blocks.rom", "-o", folder + "/matters",
             "--quiet"], *reduced):
        done = subprocess.run([deadpoint, *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL)
        if done.returncode != 0:
            raise RuntimeError(f"deadpoint {' '.join(arguments)}: {done.stderr}")
    return press, both


def main():
    deadpoint, source = sys.argv[1:3]
    rom = sys.argv[3] if len(sys.argv) > 3 and os.path.exists(sys.argv[3]) else None
    pictures = sys.argv[4] if len(sys.argv) > 4 else None
    path = browser.find()
    if path is None:
        print("skipped: there is no Chromium; scripts/install-dependencies --tests installs it")
        return 77
    with tempfile.TemporaryDirectory(prefix="deadpoint-page-") as folder:
        press, both = compute(deadpoint, source, folder, rom)
        report = press + "/report.html"
        check_pictures(folder + "/pictures")
        check(os.path.getsize(report) < 10e6, "the page is over 10 MB")
        with browser.Browser(path) as page:
            for width, height in ((360, 740), (1280, 900)):
                page.size(width, height, phone=width < 500)
                page.open(report)
                page.settle()
                near(page.run("document.documentElement.scrollWidth"), width, 0, f"{width} px: width of the page")
                check_charts(page, press, width)
                if pictures:
                    page.picture(f"{pictures}/page-{width}.png")
            check_structure(page)
            check_view(page, press)
            check_print(page, pictures)
            check_both(page, both, 2)
            for width in (360, 1280):
                check_study(page, folder + "/study", width, pictures)
            check_study_table(page, folder + "/study")
            for width in (360, 1280):
                check_sensitivity(page, folder + "/matters", width)
                if rom:
                    check_optimum(page, folder + "/warm", width)
                    check_plan(page, folder + "/plan", width)
            check_sketch(page, deadpoint, source, folder, pictures)
            check_without_scripts(page, report, ["E_SW at the end", "front left", "pivot_h", "Rises of the probes", "hash",
                                                 "Cite as", "switched off"])
            check_without_scripts(page, folder + "/study/report.html", ["Best windows", "speed=90_rpm", "-", "Cite as",
                                                                        "switched off"])
            for problem in page.problems:
                check(False, problem)
    print("all well" if not failures else f"{len(failures)} checks failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
