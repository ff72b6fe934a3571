#!/usr/bin/env python3
"""Shows how a case's results depend on the mesh, on the time steps and on the tolerance of the linear solver.

Prints docs/validation/independence.md, or writes it with --write. Every run is `deadpoint run`; runs that are already
finished (--scratch) are reused. Mesh: --size gives finer and finer meshes. A value f on cells of mean size h = cells^(-1/3) is
fitted by f0 + c h^p; f0 is the limit. p follows from least squares over all meshes, between 0.5 and 4; the limit with p = 2,
the order of first-order elements, is given as a check. Time and solver: against a run with a far smaller tolerance on the first mesh.
"""
import argparse
import datetime
import json
import math
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DOCUMENT = os.path.join(ROOT, "docs", "validation", "independence.md")
PROBE_LIMIT, GAP_LIMIT = 0.02, 1.0  # share of the rise; micrometres
# Key, its tolerances, and the one that stands for the exact solution.
LADDERS = {"Time steps": ("numerics.time_tolerance", ["0.08 K", "0.04 K", "0.02 K", "0.01 K"], "0.0004 K"),
           "Linear systems": ("numerics.solver_tolerance", ["1e-4", "1e-5", "1e-6"], "1e-9")}


def run(options, size, key="", value=""):
    name = f"size-{size:g}" + (f"-{key.split('.')[-1]}-{value.replace(' ', '')}" if key else "")
    folder = os.path.join(options.scratch, name)
    if not os.path.exists(os.path.join(folder, "summary.json")):
        command = [options.program, "run", options.case, "--size", f"{size:g}", "-o", folder, "-q", "--set",
                   "output.fields=false", "--set", "output.causes=false"]
        command += (["--set", f'{key}={value}'] if key else []) + options.more
        if subprocess.run(command, stdout=subprocess.DEVNULL, env=dict(os.environ, OMP_NUM_THREADS="1")).returncode:
            sys.exit(f"{' '.join(command)} failed")
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def least_squares(steps, values, order):
    """f0 and the sum of squares of f0 + c h^order."""
    powers = [h ** order for h in steps]
    n, sx, sy = len(steps), sum(powers), sum(values)
    sxx, sxy = sum(x * x for x in powers), sum(x * y for x, y in zip(powers, values))
    slope = (n * sxy - sx * sy) / (n * sxx - sx * sx)
    limit = (sy - slope * sx) / n
    return limit, sum((limit + slope * x - y) ** 2 for x, y in zip(powers, values))


def limits(steps, values):
    """Limit with the best order, that order, and the limit with order 2."""
    orders = [0.5 + 0.05 * k for k in range(71)]
    best = min(orders, key=lambda order: least_squares(steps, values, order)[1])
    return least_squares(steps, values, best)[0], best, least_squares(steps, values, 2)[0]


def entries(summaries):
    """(name, unit, values on the meshes) of everything that is compared."""
    probes = summaries[0]["probe_rises_K"]
    for name in probes:
        yield name, "K", [summary["probe_rises_K"][name]["end"] for summary in summaries]
    for name, key in (("E_SW at the end", "final_E_SW"), ("E_SW, largest", "largest_E_SW")):
        yield name, "um", [summary["drift_um"][key] for summary in summaries]
    for name in summaries[0]["drift_um"]["final"]:
        if name != "E_SW":
            yield f"{name} at the end", "um", [summary["drift_um"]["final"][name] for summary in summaries]


def table(head, rows):
    return "\n".join("| " + " | ".join(line) + " |" for line in [head, ["---"] + ["--:"] * (len(head) - 1), *rows]) + "\n"


def mesh_section(summaries, options):
    cells = [summary["model"]["cells"] for summary in summaries]
    steps = [count ** (-1 / 3) for count in cells]
    grouped = [f"{count:,}".replace(",", " ") for count in cells]
    own = [summary["model"]["deformation_cells"] for summary in summaries]
    rows, worst, gap = [], (0, ""), 0
    for name, unit, values in entries(summaries):
        limit, order, second = limits(steps, values)
        change = values[-1] - values[0]
        rows.append([f"{name} [{unit}]", *(f"{value:.3f}" for value in values), f"{change:+.3f}", f"{limit:.3f}", f"{order:.2f}",
                     f"{second:.3f}"])
        if unit == "K" and abs(change) > worst[0] * abs(values[-1]):
            worst = (abs(change / values[-1]), name)
        if name.startswith("E_SW"):
            gap = max(gap, abs(change))
    parts = summaries[0]["drift_um"]["final_by_part"]
    moved = sorted(((summaries[-1]["drift_um"]["final_by_part"].get(part, math.nan) - value, part)
                    for part, value in parts.items()), key=lambda entry: -abs(entry[0]))[:6]
    verdict = lambda held: "met" if held else "not met"
    return f"""## Mesh

`--size` {", ".join(f"{size:g}" for size in options.size)}. The deformation had {", ".join(
    f"{count:,}".replace(",", " ") for count in own)} cells.
Limit f0 and order p come from least squares of f0 + c h^p with h = cells^(-1/3) over all meshes, with p between 0.5 and 4. An
order at either end of that range means that the differences follow no power of h. The last column is the limit with p = 2.

{table(["", *grouped, "last - first", "limit", "order", "limit, order 2"], rows)}
From {grouped[0]} to {grouped[-1]} cells

- rises of probes change by {100 * worst[0]:.2f} % at most (`{worst[1]}`); aim: less than {100 * PROBE_LIMIT:.0f} %: **{verdict(worst[0] < PROBE_LIMIT)}**;
- E_SW changes by {gap:.2f} um at most; aim: less than {GAP_LIMIT:.0f} um: **{verdict(gap < GAP_LIMIT)}**.

The contributions of these parts to E_SW at the end change most between the first mesh and the last:

{table(["part", "change [um]"], [[part, f"{change:+.3f}"] for change, part in moved])}"""


def figures(summary):
    """Rises of all probes at all times they are noted [K], and the gap at the end [um]."""
    rises = {(probe, time): value for probe, times in summary["probe_rises_K"].items() for time, value in times.items()}
    return rises, summary["drift_um"]["final_E_SW"]


def tolerance_section(title, options):
    key, values, sharp = LADDERS[title]
    exact, gap = figures(run(options, options.size[0], key, sharp))
    rows = []
    for value in values:
        summary = run(options, options.size[0], key, value)
        rises, own = figures(summary)
        worst = max(rises, key=lambda place: abs(rises[place] - exact[place]))
        solution = summary["solution"]
        rows.append([value, str(solution["steps"]), str(solution["heat_iterations"]), f"{abs(rises[worst] - exact[worst]):.2g}",
                     f"{worst[0]}, {worst[1]}", f"{own - gap:+.2g}", f"{summary['energy_J']['relative_mismatch']:.1e}"])
    return f"""## {title}

Each row is compared with `{key}` = {sharp} on the first mesh; E_SW there is {gap:.4f} um.

{table([f"`{key}`", "steps", "iterations", "largest difference of a rise [K]", "at", "of E_SW [um]", "heat balance"], rows)}"""


def document(options):
    return f"""# What the results depend on

Written by `scripts/independence.py --write` on {datetime.date.today()}, version {run(options, options.size[0])["version"]}:
`{os.path.relpath(os.path.abspath(options.case), ROOT)}`, three hours of operation, everything else as shipped.

""" + "\n".join([mesh_section([run(options, size) for size in options.size], options),
                 *(tolerance_section(title, options) for title in LADDERS)])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/app/deadpoint"))
    parser.add_argument("--case", default=os.path.join(ROOT, "cases/jl75g-60/case.toml"))
    parser.add_argument("--size", type=float, action="append", help="coarsest first")
    parser.add_argument("--scratch", default="build/independence", help="where results are kept")
    parser.add_argument("--write", action="store_true", help="write docs/validation/independence.md")
    parser.add_argument("more", nargs="*", help="further options of `deadpoint run`, after --")
    options = parser.parse_args()
    options.size = options.size or [1, 0.77, 0.6, 0.4]
    text = document(options)
    if options.write:
        with open(DOCUMENT, "w") as file:
            file.write(text)
    else:
        print(text)


if __name__ == "__main__":
    main()
