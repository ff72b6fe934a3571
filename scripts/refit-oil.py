#!/usr/bin/env python3
"""Refits the three oil coefficients of the case jl75g-60 to the eight published rises of its base case.

Free are the coefficients of the rolling joints, of the plain joints and guides, and of joint 9-10; all else stays as in the
case. Each trial is a run of the program on a coarse mesh, heat only. The sum of squared differences is minimised by
Levenberg-Marquardt in the logarithms of the coefficients, with derivatives by finite differences.
"""

import argparse
import json
import math
import re
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

from shared.fitting import fit
from shared.judging import rms

ROOT = Path(__file__).resolve().parent.parent
CASES = ROOT / "cases" / "jl75g-60"
ROLLING = {"crank_bearings", "links_8_11", "link_11_slider_12"}
JOINT_9_10 = {"link_9_slider_10"}
NAMES = ("rolling", "plain", "joint 9-10")

LEAST, MOST = 0.1, 1e5  # bounds of a coefficient [W/m2/K]


def fail(message, remedy):
    sys.exit(f"error: {message}\n  help: {remedy}")


def group_of(row):
    """Number of the free coefficient that the row of [oil] belongs to."""
    return 0 if row in ROLLING else 2 if row in JOINT_9_10 else 1


def read_oil(case):
    """Rows of [oil] and the three coefficients [W/m2/K] that the case starts with."""
    rows = tomllib.loads(case.read_text()).get("oil", {})
    start = [None, None, None]
    for row, text in rows.items():
        number, _, unit = text.partition(" ")
        if unit != "W/m^2/K":
            fail(f"oil.{row} of {case} is '{text}'", "write it in W/m^2/K for this script")
        start[group_of(row)] = float(number)
    if None in start:
        fail(f"{case} lacks oil on: {NAMES[start.index(None)]}", "take cases/jl75g-60/oil.toml")
    return list(rows), start


def copy_heat_only(case, folder):
    """Copies the case and what lies beside it without [chain], so that no deformation is computed; returns the copy."""
    for source in case.parent.glob("*.toml"):
        text = re.sub(r"^\[chain\][^\n]*\n(?:(?!\[).*\n?)*", "", source.read_text(), flags=re.MULTILINE)
        (folder / source.name).write_text(text)
    return folder / case.name


class Model:
    """Runs of the program: from the logarithms of the coefficients to computed minus published rises [K]."""

    def __init__(self, program, case, rows, size, folder):
        self.command = [program, "run", case, "-o", folder / "run", "--force", "--quiet", "--size", str(size)]
        self.command += ["--set", "output.fields=false"]
        self.rows, self.results, self.runs = rows, folder / "run" / "summary.json", 0

    def differences(self, logs):
        command = list(self.command)
        for row in self.rows:
            command += ["--set", f"oil.{row}={math.exp(logs[group_of(row)]):.8g} W/m^2/K"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            fail(f"the program ended with code {done.returncode}:\n{done.stderr[-2000:]}", "see above")
        self.runs += 1
        rises = json.loads(self.results.read_text())["reference"]["rises_K"]
        return {probe: rise["computed"] - rise["reference"] for probe, rise in sorted(rises.items())}


def report(label, runs, logs, differences):
    root = rms(differences.values())
    coefficients = "  ".join(f"{math.exp(value):10.4g}" for value in logs)
    print(f"{label:>9}  {runs:4}  {coefficients}  {root:7.3f}", flush=True)


def rounded(value):
    """Three significant digits, without an exponent."""
    return f"{float(f'{value:.3g}'):g}"


def write(target, rows, values):
    """Replaces the coefficients in the file, which keeps everything else."""
    text = target.read_text()
    for row in rows:
        line = f'{row} = "{values[group_of(row)]} W/m^2/K"'
        text, found = re.subn(rf'^{row} = "[^"]* W/m\^2/K"', line, text, flags=re.MULTILINE)
        if found != 1:
            fail(f"{target} has {found} lines for oil.{row} instead of one", "mend its [oil] table")
    target.write_text(text)


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/app/deadpoint", help="what computes the case")
    parser.add_argument("--case", type=Path, default=CASES / "oil.toml", help="case with the coefficients to start from")
    parser.add_argument("--size", type=float, default=1.6, help="factor on the cell sizes (default: %(default)s)")
    parser.add_argument("--iterations", type=int, default=8, help="at most so many (default: %(default)s)")
    parser.add_argument("--write", action="store_true", help="put the result into cases/jl75g-60/oil-refitted.toml")
    return parser.parse_args()


def main():
    given = options()
    if not given.program.is_file():
        fail(f"there is no program {given.program}", "build it with 'make build', or name it with --program")
    rows, start = read_oil(given.case)
    with tempfile.TemporaryDirectory(prefix="refit-oil-") as name:
        folder = Path(name)
        case = copy_heat_only(given.case.resolve(), folder)
        model = Model(given.program.resolve(), case, rows, given.size, folder)
        print("iteration  runs     rolling       plain  joint 9-10  rms [K]   (coefficients in W/m2/K)")
        logs, differences, note = fit(model.differences, [math.log(value) for value in start], given.iterations,
                                      (math.log(LEAST), math.log(MOST)), lambda *state: report(state[0], model.runs, *state[1:]))
        print(note)
    values = [rounded(math.exp(value)) for value in logs]
    print("computed minus published [K]: " + ", ".join(f"{probe} {value:+.2f}" for probe, value in differences.items()))
    print("result [W/m2/K]: " + ", ".join(f"{name} {value}" for name, value in zip(NAMES, values)))
    if given.write:
        write(CASES / "oil-refitted.toml", rows, values)
        print("written to cases/jl75g-60/oil-refitted.toml")


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
