#!/usr/bin/env python3
"""Shows how far reduced models are off: writes docs/validation/reduced.md with --write, else prints it.

For each shipped case, and for the starter press with two parts from STEP files: `deadpoint reduce` with --full-runs, a full
run of the case itself, and `deadpoint run --reduced`. For the shipped press with oil also narrower ranges, and
benchmark_reduced_checks: full runs that the build never saw. What is already in --scratch is reused.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from shared import rom_file  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DOCUMENT = os.path.join(ROOT, "docs", "validation", "reduced.md")
# Case, and the scale of its cell sizes.
CASES = [("jl75g-60/oil", 1), ("jl75g-60/case", 2), ("jl75g-60/physics", 2), ("jl75g-60/environment", 2),
         ("jl75g-60/working-day", 2), ("knuckle-joint/case", 1), ("slider-crank/case", 1), ("starter/case", 1),
         ("starter-by-laws/case", 1), ("starter-step/case", 1)]
HELD = ["reduce.film=[1, 1]", "reduce.conductance=[1, 1]", "reduce.oil=[1, 1]"]
# Ranges of the shipped press with oil that are narrower than the default ones, and the largest number of states.
NARROW = [("as in the case: films, conductances and oil each as a whole", 200, ["reduce.together=true"]),
          ("heat of each friction law, ambient and oil temperature only", 120, HELD),
          ("speed (0.5 to 1.2 times), force (0 to 1.2 times), ambient and oil temperature only", 120,
           HELD + ["reduce.friction=[1, 1]", "reduce.speed=[0.5, 1.2]", "reduce.force=[0, 1.2]"])]
NARROW_SIZE = 3
CHECKED, FIRST_CYCLE = "jl75g-60-oil", 1000
HEAD = """<!-- Written by scripts/reduced.py. Do not edit. -->

# Reduced models against full runs

Shipped cases, reduced with the ranges that `[reduce]` has by default: each film of each surface on each part
0.2 to 5 times the case's, each side of each interface 0.1 to 10 times, oil 0 to 5 times, friction heat 0.3 to 3
times, oil -10 to +20 K, ambient -10 to +10 K, half of the warm-ups with a pause of half an hour. Errors are
the largest of all probes, of both sides of all interfaces, and of E_SW, after the first minute of each segment.
[reduced.md](../reduced.md) derives the models.

"""


def call(command):
    done = subprocess.run(command, stdout=subprocess.DEVNULL, env=dict(os.environ, OMP_NUM_THREADS="1"))
    if done.returncode:
        sys.exit(f"{' '.join(command)} failed")


def summary_of(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def run(options, case, name, more):
    folder = os.path.join(options.scratch, name)
    if not os.path.exists(os.path.join(folder, "summary.json")):
        call([options.program, "run", case, "-o", folder, "-q", "--set", "output.fields=false", *more])
    return summary_of(folder)


def reduced(options, case, name, size):
    file = os.path.join(options.scratch, name + ".rom")
    if not os.path.exists(file):
        call([options.program, "reduce", case, "-o", file, "-q", "--full-runs", str(options.full_runs),
                        "--size", f"{size:g}", *(["--certify"] if name == CHECKED else [])])
    return file, rom_file.read_rom(file, checksum=False)


def stepped_starter(scratch):
    """The starter case with its bed and the front of its crown from STEP files, which are meshed by tetrahedra."""
    folder = os.path.join(scratch, "starter-step")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(ROOT, "cases", "starter", "case.toml")) as file:
        parts = file.read().split("\n[parts.")
    for place, part in enumerate(parts):
        name = part.split("]")[0]
        step = os.path.join(ROOT, "tests", "data", f"starter_{name}.step")
        if os.path.exists(step):
            shutil.copy(step, folder)
            rest = part.partition("\n\n")[2]
            parts[place] = f'{name}]\nbody = "frame"\nmaterial = "cast_iron"\nsize = "40 mm"\nstep = "{os.path.basename(step)}"\n{rest}'
    case = os.path.join(folder, "case.toml")
    with open(case, "w") as file:
        file.write("\n[parts.".join(parts))
    return case


def is_ready(options, name):
    return not options.ready or os.path.exists(os.path.join(options.scratch, name + ".rom"))


def narrow_row(options, place):
    meaning, states, settings = NARROW[place]
    file = os.path.join(options.scratch, f"narrow{place}.rom")
    if not os.path.exists(file):
        more = [word for setting in settings + [f"reduce.states={states}", 'reduce.temperature="0.001 K"', 'reduce.gap="0.001 um"']
                for word in ("--set", setting)]
        call([options.program, "reduce", os.path.join(ROOT, "cases", "jl75g-60", "oil.toml"), "-o", file, "-q", "--full-runs",
              str(options.full_runs), "--size", f"{NARROW_SIZE * options.size:g}", *more])
    rom = rom_file.read_rom(file, checksum=False)
    errors = rom["errors"]
    return (f"| {meaning} | {rom['part_states']['rows']} | {cell(error_of(errors, 'anywhere'))} | "
            f"{cell(error_of(errors, 'as in the case, to a full run'))} | {cell(next((e for e in errors if 'drawn' in e['of']), None))} |")


def rows_of(file):
    """The whole lines of numbers of a file, which may not be there."""
    if not os.path.exists(file):
        return []
    with open(file) as lines:
        return [line for line in lines if len(line.split()) == 9 and line.endswith("\n")]


def checks(options, name, first, count, *more):
    """Rows of numbers of benchmark_reduced_checks. What an earlier call did is not done again."""
    file = os.path.join(options.scratch, name + ".txt")
    done = rows_of(file)
    if len(done) < count and not options.ready:
        with open(file, "w") as out:
            out.writelines(done)
            out.flush()
            subprocess.run([options.checks, os.path.join(ROOT, "cases", "jl75g-60", "oil.toml"),
                            os.path.join(options.scratch, CHECKED + ".rom"), "1", str(first + len(done)), str(count - len(done)),
                            *more, "keep=" + os.path.join(options.scratch, "full-runs")], stdout=out, check=True, env=dict(os.environ, OMP_NUM_THREADS="1"))
    return [[float(word) for word in line.split()] for line in rows_of(file)]


def checks_row(meaning, rows):
    if not rows:
        return f"| {meaning} | 0 |" + " - |" * 11
    columns = list(zip(*rows))
    worst = [max(columns[k]) for k in range(1, 9)]
    over = max(max(abs(row[3] - row[5]) for row in rows), 0), max(abs(row[4] - row[6]) for row in rows)
    held = sum(row[8] >= row[7] for row in rows)
    bounds = sorted(columns[8])
    return (f"| {meaning} | {len(rows)} | {worst[2]:.3f} | {worst[3]:.3f} | {worst[0]:.3f} | {worst[1]:.3f} | {over[0]:.3f} | "
            f"{over[1]:.3f} | {worst[6]:.3f} | {held} | {bounds[0]:.2f} | {bounds[len(bounds) // 2]:.2f} | {bounds[-1]:.2f} |")


def share_within(rows):
    """What was asked for, and in how many runs it is so. Columns as of benchmark_reduced_checks."""
    count = len(rows)
    asked = [("the small model is within 0.13 K", [row[3] <= 0.13 for row in rows]),
             ("and within 0.05 um", [row[4] <= 0.05 for row in rows]),
             ("the estimate is within 0.01 K of the error", [abs(row[3] - row[5]) <= 0.01 for row in rows]),
             ("and within 0.005 um", [abs(row[4] - row[6]) <= 0.005 for row in rows]),
             ("the bound is below 0.25 um", [row[8] < 0.25 for row in rows])]
    return f"Of these {count} runs, " + ", ".join(f"{what} in {sum(found)}" for what, found in asked) + "."


def error_of(errors, start):
    return next((e for e in errors if e["of"].startswith(start)), None)


def cell(error):
    return f"{error['temperature']:.3f} | {1e6 * error['gap']:.3f}" if error else "- | -"


def largest_rise_difference(one, other):
    return max((abs(one["probe_rises_K"][p]["end"] - other["probe_rises_K"][p]["end"])
                for p in one["probe_rises_K"]), default=float("nan"))


def page(options):
    rows, sizes, missing = [], [], []
    for name, size in CASES:
        if options.cases and name not in options.cases:
            continue
        size *= options.size
        flat = name.replace("/", "-")
        if options.ready and not os.path.exists(os.path.join(options.scratch, flat + "-reduced", "summary.json")):
            missing.append(name)
            continue
        case = stepped_starter(options.scratch) if name == "starter-step/case" else os.path.join(ROOT, "cases", name + ".toml")
        file, rom = reduced(options, case, flat, size)
        full = run(options, case, flat + "-full", ["--size", f"{size:g}"])
        quick = run(options, case, flat + "-reduced", ["--reduced", file])
        drawn = next((e for e in rom["errors"] if "drawn" in e["of"]), None)
        gap = [s.get("drift_um", {}).get("final_E_SW", float("nan")) for s in (full, quick)]
        rows.append(f"| {name}{f', --size {size:g}' if size != 1 else ''} | {rom['unknowns']} | {rom['part_states']['rows']} | {len(rom['box'])} | "
                    f"{os.path.getsize(file) / 1e6:.1f} | {cell(error_of(rom['errors'], 'anywhere'))} | "
                    f"{drawn['of'].split()[0] if drawn else 0} | {cell(drawn)} | {largest_rise_difference(full, quick):.3f} | {gap[0]:.3f} | {gap[1]:.3f} |")
        sizes += [f"| {name} | {s['states']} | {s['temperature']:.3f} | {1e6 * s['gap']:.3f} |" for s in rom["sizes"]]
    sets, cycles = checks(options, "sets", 0, options.sets), checks(options, "cycles", FIRST_CYCLE, options.cycles, "cycles")
    return HEAD + """## Cases

Columns in this order: unknowns of the full model; states; free coefficients; size of the file in MB; largest error
anywhere in the ranges, against the large model (13 warm-ups); number of full runs with drawn coefficients, and the largest error against them; then the case itself with its own laws of convection: largest difference of
the probes' rises at the end, and E_SW at the end of the full and of the reduced run.

| case | unknowns | states | coefficients | MB | ranges [K] | [um] | drawn | [K] | [um] | rises [K] | E_SW full [um] | reduced |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
""" + "\n".join(rows) + """

""" + (f"Not computed with the present program: {', '.join(missing)}.\n\n" if missing else "") + """starter-step is the starter press with its bed and the front of its crown from STEP files, meshed by tetrahedra.

## Full runs that the build never saw

The shipped press with oil, on its own mesh, with coefficients drawn anywhere in the ranges; half of the sets with a pause.
The cycles change between work of 10 to 50 minutes, at 0.3 to 1.5 times the heat, and rest of 5 to 30 minutes. Columns: number
of full runs; largest error of the small model and of the large one; largest difference between the estimate (small to large
model) and the error; largest error of the large model in E_SW at the end; how often its certified bound held; smallest,
median and largest bound.

| | runs | small [K] | [um] | large [K] | [um] | estimate [K] | [um] | at the end [um] | held | bound [um] | | |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
""" + checks_row("random sets", sets) + "\n" + checks_row("duty cycles", cycles) + "\n\n" + share_within(sets + cycles) + """

## Narrower ranges

The shipped press with oil at `--size """ + str(NARROW_SIZE) + """`. Errors to the large model in 13 warm-ups, to a full run of the case, and to full runs with drawn
coefficients.

| free | states | ranges [K] | [um] | case [K] | [um] | drawn [K] | [um] |
|---|--:|--:|--:|--:|--:|--:|--:|
""" + "\n".join(narrow_row(options, place) for place in range(len(NARROW)) if is_ready(options, f"narrow{place}") and not options.cases) + """

## Error over the number of states

Anywhere in the ranges, against the large model.

| case | states | K | um |
|---|--:|--:|--:|
""" + "\n".join(sizes) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "ci", "app", "deadpoint"))
    parser.add_argument("--checks", default=os.path.join(ROOT, "build", "ci", "benchmarks", "benchmark_reduced_checks"))
    parser.add_argument("--scratch", required=True)
    parser.add_argument("--full-runs", type=int, default=4)
    parser.add_argument("--sets", type=int, default=100)
    parser.add_argument("--cycles", type=int, default=20)
    parser.add_argument("--size", type=float, default=1, help="factor on all cell sizes: a trial")
    parser.add_argument("--cases", nargs="+", help="only these of the shipped cases, like starter/case: a trial")
    parser.add_argument("--ready", action="store_true", help="only what is in --scratch already; the page names the rest")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    os.makedirs(options.scratch, exist_ok=True)
    text = page(options)
    if not options.write:
        print(text)
        return
    with open(DOCUMENT, "w") as file:
        file.write(text)


if __name__ == "__main__":
    main()
