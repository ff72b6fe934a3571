#!/usr/bin/env python3
"""Writes docs/validation/verification.md from the figures that the verification tests compared with their targets.

The tests write them to the path in DEADPOINT_RECORD; `ctest` sets it to BUILD/validation/NAME.tsv, and the errors behind orders of
convergence to NAME.tsv.orders, which --write draws beside the page as orders.svg. Without an option the script prints the
page. --check compares figures and verdicts with the existing page and ignores date and version.
"""

import argparse
import datetime
import math
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "validation" / "verification.md"
PLOTS = PAGE.with_name("orders.svg")
HEADING = "| requirement | source | expected | got | tolerance | unit | reason for the tolerance | verdict |"


def fail(text, remedy):
    sys.exit(f"error: {text}\n  help: {remedy}")


def rows_of(folder):
    rows = []
    for file in sorted(folder.glob("*.tsv")):
        for line in file.read_text().splitlines():
            requirement, source, unit, expected, got, tolerance, reason = line.split("\t")
            rows.append((requirement, source, float(expected), float(got), float(tolerance), unit, reason))
    if not rows:
        fail(f"{folder} holds no rows", "run `ctest -R verification` in the build folder first")
    return rows


def series_of(folder):
    """Errors over sizes by test: (requirement, order by theory, unit, [(size, error), ...])."""
    series = []
    for file in sorted(folder.glob("*.tsv.orders")):
        for line in file.read_text().splitlines():
            requirement, order, unit, *numbers = line.split("\t")
            numbers = [float(n) for n in numbers]
            series.append((requirement, float(order), unit, list(zip(numbers[::2], numbers[1::2]))))
    if not series:
        fail(f"{folder} holds no errors for the plots", "run `ctest -R verification` in the build folder first")
    return series


COLOURS = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b", "#e377c2", "#7f7f7f", "#bcbd22"]
WIDTH, LEFT, PLOT, HEIGHT, LINE = 900, 70, 300, 250, 15


def panel(title, series, top):
    """One chart of errors over sizes, both by powers, each series from its coarser mesh or step on, with its theory dashed."""
    errors = [error for *_, points in series for _, error in points]
    low, high = math.floor(math.log10(min(errors)) - 0.05), math.ceil(math.log10(max(errors)) + 0.05)
    finest = min(points[-1][0] / points[0][0] for *_, points in series)
    x = lambda ratio: LEFT + PLOT * (1 + 0.9 * math.log(ratio) / -math.log(finest))
    y = lambda error: top + 30 + HEIGHT * (high - math.log10(error)) / (high - low)
    text = [f'<text x="{LEFT}" y="{top + 18}" font-weight="bold">{title} [{series[0][2]}]</text>',
            f'<rect x="{LEFT}" y="{top + 30}" width="{PLOT}" height="{HEIGHT}" fill="none" stroke="#888"/>']
    for power in range(low, high + 1):
        at = y(10.0**power)
        text.append(f'<line x1="{LEFT}" x2="{LEFT + PLOT}" y1="{at:.1f}" y2="{at:.1f}" stroke="#ddd"/>'
                    f'<text x="{LEFT - 6}" y="{at + 4:.1f}" text-anchor="end">1e{power}</text>')
    for ratio in sorted({points[-1][0] / points[0][0] for *_, points in series} | {1.0}):
        text.append(f'<text x="{x(ratio):.1f}" y="{top + HEIGHT + 46}" text-anchor="middle">{ratio:.3g}</text>')
    for i, (requirement, order, _, points) in enumerate(series):
        colour, (coarse, start) = COLOURS[i % len(COLOURS)], points[0]
        places = [(x(size / coarse), y(error)) for size, error in points]
        text.append(f'<polyline points="{" ".join(f"{a:.1f},{b:.1f}" for a, b in places)}" fill="none" stroke="{colour}"/>')
        text += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3" fill="{colour}"/>' for a, b in places]
        ratio = points[-1][0] / coarse
        text.append(f'<line x1="{x(1):.1f}" y1="{y(start):.1f}" x2="{x(ratio):.1f}" y2="{y(start * ratio**order):.1f}" '
                    f'stroke="{colour}" stroke-dasharray="5 4" opacity="0.6"/>')
        seen = math.log(start / points[-1][1]) / math.log(coarse / points[-1][0])
        name = requirement.split(", ", 2 if requirement.startswith("order in space") else 1)[-1]
        text.append(f'<circle cx="{LEFT + PLOT + 20}" cy="{top + 36 + LINE * 1.6 * i:.1f}" r="4" fill="{colour}"/>'
                    f'<text x="{LEFT + PLOT + 30}" y="{top + 40 + LINE * 1.6 * i:.1f}">{seen:.2f} ({order:g}): {name}</text>')
    return text


def plots(series):
    """Charts of all errors, one for each kind of order."""
    groups = {}
    for one in series:
        kind = ", ".join(one[0].split(", ")[:2]) if one[0].startswith("order in space") else "order in time"
        groups.setdefault(kind, []).append(one)
    tops = [20 + i * (HEIGHT + 90) for i in range(len(groups))]
    text = [line for top, (title, some) in zip(tops, groups.items()) for line in panel(title, some, top)]
    height = tops[-1] + HEIGHT + 70
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" font-family="sans-serif" font-size="12">',
        '<rect width="100%" height="100%" fill="white"/>', *text, "</svg>", ""])


def table(rows):
    text = [HEADING, "|---|---|---|---|---|---|---|---|"]
    for requirement, source, expected, got, tolerance, unit, reason in rows:
        verdict = "met" if abs(got - expected) <= tolerance else "**missed**"
        text.append(f"| {requirement} | {source} | {expected:.8g} | {got:.8g} | {tolerance:.2g} | {unit} | {reason} | {verdict} |")
    return text


def page(rows):
    version = re.search(r"project\(\S+ VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    missed = sum(abs(r[3] - r[2]) > r[4] for r in rows)
    return "\n".join([
        "# Verification", "",
        f"Written by `make validate` on {datetime.date.today()}, version {version}: {len(rows)} figures, {missed} missed.",
        "Each row is a figure that a test of `tests/verification` compares with its target; the test fails if the difference",
        "exceeds the tolerance. Targets are exact solutions, published benchmarks, orders of convergence and invariants.", "",
        "![Errors over sizes of cells and time steps](orders.svg)", "",
        "The charts show errors over the size of cells or of time steps, relative to the coarsest. For mean displacements and for time",
        "steps they show differences from one run to the next finer one. Dashed lines have the theoretical order, which stands in",
        "brackets beside the observed order.",
        "", *table(rows), ""])


def cells(line):
    return [c.strip() for c in line.strip("|").split("|")]


def check(rows):
    """Rows of another machine may differ by rounding: half the tolerance, or 1e-6 of the figure."""
    standing = {cells(line)[0]: [] for line in PAGE.read_text().splitlines() if line.startswith("| ")}
    for line in PAGE.read_text().splitlines():
        if line.startswith("| "):
            standing[cells(line)[0]].append(cells(line))
    problems, seen = [], {}
    for row in rows:
        name = row[0]
        index = seen[name] = seen.get(name, -1) + 1
        known = standing.get(name, [])
        if index >= len(known):
            problems.append(f"not in the page: {name}")
            continue
        _, _, expected, got, tolerance, _, _, verdict = known[index]
        allowed = max(0.5 * row[4], 1e-6 * abs(row[3]))
        if abs(float(got) - row[3]) > allowed or abs(float(expected) - row[2]) > 1e-7 * abs(row[2]) or verdict != "met":
            problems.append(f"{name}: the page has {got} (expected {expected}, {verdict}), the test {row[3]:.8g}")
    count = sum(len(v) for k, v in standing.items() if k != "requirement")
    if count != len(rows):
        problems.append(f"the page has {count} rows, the tests {len(rows)}")
    if problems:
        fail("docs/validation/verification.md does not agree with the tests:\n  " + "\n  ".join(problems[:20]),
             "run `make validate` and look at what it changes")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rows", type=Path, nargs="?", default=ROOT / "build" / "release" / "validation")
    parser.add_argument("--write", action="store_true", help="write the page")
    parser.add_argument("--check", action="store_true", help="compare with the page as it stands")
    options = parser.parse_args()
    rows = rows_of(options.rows)
    if options.check:
        check(rows)
    elif options.write:
        PAGE.write_text(page(rows))
        PLOTS.write_text(plots(series_of(options.rows)))
    else:
        print(page(rows))


if __name__ == "__main__":
    main()
