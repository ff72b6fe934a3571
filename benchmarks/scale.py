#!/usr/bin/env python3
"""How the shipped press scales from 0.1 to 2.4 million cells: time and memory of every stage of `deadpoint run`, and of the
heat's steps against the memory traffic that their multigrid cannot do without.

Prints a table in Markdown; nothing here is a test. Usage:
  benchmarks/scale.py [--program build/release/app/deadpoint] [--case cases/jl75g-60/case.toml] [--size 1 --size 0.57 ...]
                   [--ranks 1 --ranks 2] [--heat-only] [-- --set ...]
With --heat-only the case's dimension chain is taken out, and with it the deformation.

Least traffic. The solver's own report (-heat_ksp_view) gives rows n and entries z of every level, and the entries of the
interpolations on one rank. A sweep of a matrix in double precision reads 12 z bytes (value and column) and 4 n of row
starts, and moves four vectors of 8 n: in, out, right side, diagonal. A cycle of two Chebyshev steps before (from zero)
and after takes 1 + 2 sweeps and one more for the residual on every level but the coarsest, and conjugate gradients one
more on the finest with six vectors. Between two levels the interpolation is read twice, with three vectors of the finer
level; on several ranks its entries are not known and count as none. Divided by the bandwidth of the triad
(benchmarks/triad.c) on as many processes, before and after the run, whichever is more, this is the least time. There is
one cycle an iteration. The program's cycle is single, so that its own least is lower; the double one stays the measure.
The time this is held against is that of all time steps: with the rates between solves and the systems; the hierarchy is
made once, with the heat matrices.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
STAGES = ("mesh", "unknowns", "dimension chain", "heat matrices", "time steps", "fields", "view")


def bandwidth(ranks, scratch):
    program = os.path.join(scratch, "triad")
    if not os.path.exists(program):
        subprocess.run(["cc", "-O3", "-march=native", "-o", program, os.path.join(HERE, "triad.c")], check=True)
    side_by_side = [subprocess.Popen([program], stdout=subprocess.PIPE, text=True) for _ in range(ranks)]
    return sum(float(process.communicate()[0].split()[0]) for process in side_by_side)


def levels(text):
    """Rows, entries and interpolation's entries of the levels in the last report, finest last, without the coarsest."""
    last = text.split("KSP Object: (heat_)")[-1]
    found = re.findall(r"cycle level: rows=(\d+) entries=(\d+) interpolation=(\d+)", last)
    return [tuple(int(number) for number in level) for level in found]


def traffic(sizes, solution):
    """Bytes of all cycles and iterations of a run, in double precision."""
    iterations = solution["heat_iterations"]
    sweep = lambda rows, entries: 12 * entries + 4 * rows + 4 * 8 * rows
    cycle = sum(4 * sweep(rows, entries) + 3 * 8 * rows + 2 * 12 * between for rows, entries, between in sizes)
    rows, entries, _ = sizes[-1]
    return iterations * (cycle + 12 * entries + 4 * rows + 6 * 8 * rows)


def without_chain(case, scratch):
    """A copy of the case's folder without its [chain]."""
    folder = os.path.join(scratch, "heat-only")
    shutil.copytree(os.path.dirname(os.path.abspath(case)), folder, dirs_exist_ok=True)
    for name in os.listdir(folder):
        if name.endswith(".toml"):
            with open(os.path.join(folder, name)) as file:
                text = file.read()
            with open(os.path.join(folder, name), "w") as file:
                file.write(re.sub(r"(?ms)^\[chain\]$.*?(?=^\[)", "", text))
    return os.path.join(folder, os.path.basename(case))


def run(options, size, ranks, scratch):
    folder, log = os.path.join(scratch, f"{size}-{ranks}"), os.path.join(scratch, f"{size}-{ranks}.log")
    command = [options.program, "run", options.case, "--size", str(size), "--ranks", str(ranks), "-o", folder, "-q"]
    command += (["--set", "output.fields=false"] if options.heat_only else []) + options.more
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       PETSC_OPTIONS="-heat_ksp_view")
    before = bandwidth(ranks, scratch)
    start, used = time.time(), os.times()
    with open(log, "w") as out:
        if subprocess.run(command, env=environment, stdout=out, stderr=subprocess.STDOUT).returncode != 0:
            sys.exit(f"{' '.join(command)} failed; see {log}")
    wall, after = time.time() - start, os.times()
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    with open(log) as file:
        text = file.read()
    sizes = levels(text)
    return {"size": size, "ranks": ranks, "wall": wall, "levels": sizes,
              "processor": after.children_user + after.children_system - used.children_user - used.children_system,
              "bandwidth": max(before, bandwidth(ranks, scratch)),
              "bytes": traffic(sizes, summary["solution"]), "summary": summary}


def row(result):
    summary = result["summary"]
    model, solution, times = summary["model"], summary["solution"], summary["timings_s"]
    steps = times["time steps"]
    least = result["bytes"] / result["bandwidth"]
    stages = [f"{times.get(stage, 0):.1f}" for stage in STAGES]
    return [f"{model['cells']:,}".replace(",", " "), f"{model.get('deformation_cells', 0):,}".replace(",", " "),
            str(result["ranks"]), f"{result['wall']:.0f}", f"{result['processor']:.0f}", *stages,
            f"{summary['peak_memory_bytes'] / 1e9:.2f}", str(solution["steps"]), str(solution["heat_iterations"]),
            f"{1e6 * steps / model['cells'] / solution['steps']:.2f}", f"{result['bandwidth'] / 1e9:.1f}", f"{steps / least:.2f}",
            f"{summary['drift_um']['final_E_SW']:+.3f}" if "drift_um" in summary else ""]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/app/deadpoint")
    parser.add_argument("--case", default="cases/jl75g-60/case.toml")
    parser.add_argument("--size", type=float, action="append")
    parser.add_argument("--ranks", type=int, action="append")
    parser.add_argument("--heat-only", action="store_true")
    parser.add_argument("--scratch", help="keep results and logs here")
    parser.add_argument("more", nargs="*", help="further options of `deadpoint run`, after --")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        scratch = options.scratch or temporary
        os.makedirs(scratch, exist_ok=True)
        if options.heat_only:
            options.case = without_chain(options.case, scratch)
        head = ["cells", "of the deformation", "ranks", "wall [s]", "processor [s]", *(f"{stage} [s]" for stage in STAGES),
                "memory [GB]", "steps", "iterations", "per cell and step [us]", "triad [GB/s]", "steps / least traffic", "E_SW [um]"]
        print("| " + " | ".join(head) + " |\n" + "|" + "--:|" * len(head), flush=True)
        for size in options.size or [1, 0.57, 0.28]:
            for ranks in options.ranks or [1, 2]:
                print("| " + " | ".join(row(run(options, size, ranks, scratch))) + " |", flush=True)


if __name__ == "__main__":
    main()
