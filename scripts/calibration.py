#!/usr/bin/env python3
"""Shows what calibration finds: writes docs/validation/calibration.md with --write, else prints it.

The paper's press: `deadpoint reduce` of cases/jl75g-60/oil.toml with wide ranges, then `deadpoint calibrate` with
cases/jl75g-60/calibration.toml. Synthetic presses: benchmark_calibration_coverage on the starter press, whose truths are
computed on a finer mesh. What is already in --scratch is reused.
"""
import argparse
import json
import math
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DOCUMENT = os.path.join(ROOT, "docs", "validation", "calibration.md")
PRESS = os.path.join(ROOT, "cases", "jl75g-60")
STARTER = os.path.join(ROOT, "cases", "starter", "case.toml")
RANGES = ["reduce.friction=[0.2, 12]", "reduce.oil=[0, 12]"]
SPEEDS, FORCES, BEARINGS = ["300 rpm", "400 rpm"], ["without force", "100 kN", "400 kN"], ["soft bearings", "stiff bearings"]
COVERAGE = [(1, 200), (2, 200), (4, 200), (5, 200), (6, 40), (7, 40), (8, 40), (9, 40)]  # line of the benchmark, draws
HEAD = """<!-- Written by scripts/calibration.py. Do not edit. -->

# Calibration

[calibration.md](../calibration.md) has the statistics. This page shows them on the paper's press and on synthetic ones.

"""


def call(command, output=None):
    done = subprocess.run(command, stdout=output or subprocess.DEVNULL, env=dict(os.environ, OMP_NUM_THREADS="1"))
    if done.returncode:
        sys.exit(f"{' '.join(command)} failed")


def reduced(options, name, case, more):
    file = os.path.join(options.scratch, name)
    if not os.path.exists(file):
        call([options.program, "reduce", case, "-q", "-o", file, *more])
    return file


def settings(texts):
    return [word for text in texts for word in ("--set", text)]


def rms(curves, key):
    count = sum(curve["values"] for curve in curves)
    return math.sqrt(sum(curve["values"] * curve[key] ** 2 for curve in curves) / count)


def group_row(name, curves):
    baselines = [rms(curves, key) for key in ("rms", "rms_of_case", "rms_of_no_change")]
    mean = [curve for curve in curves if curve["rms_of_mean"] is not None]
    inside = sum(curve["values"] * curve["inside_band"] for curve in curves) / sum(curve["values"] for curve in curves)
    return (f"| {name} | {sum(curve['values'] for curve in curves)} | " + " | ".join(f"{value:.2f}" for value in baselines)
            + f" | {rms(mean, 'rms_of_mean'):.2f} | {100 * inside:.0f} % |\n")


def fitted(options, name, file, case="oil-with-speed.toml"):
    """What `deadpoint calibrate` finds for the press."""
    model = reduced(options, "press.rom", os.path.join(PRESS, "oil.toml"), settings(RANGES) + ["--full-runs", "1", "--size", f"{options.size:g}"])
    folder = os.path.join(options.scratch, name)
    if not os.path.exists(os.path.join(folder, "calibration.json")):
        call([options.program, "calibrate", os.path.join(PRESS, case), file, "--reduced", model, "-q", "-o",
              folder])
    with open(os.path.join(folder, "calibration.json")) as result:
        return json.load(result)


def without_growth(options):
    """The calibration file of the press, less the exponent."""
    with open(os.path.join(PRESS, "calibration.toml")) as file:
        blocks = file.read().split("[[parameters]]")
    text = "[[parameters]]".join(block for block in blocks if "oil_with_speed.*" not in block)
    for name in ("paper.toml", "paper-sweeps.toml"):
        text = text.replace(f'"{name}"', json.dumps(os.path.join(PRESS, name)))
    path = os.path.join(options.scratch, "without-growth.toml")
    with open(path, "w") as file:
        file.write(text)
    return path


def growth_verdict(options, found, speeds):
    """Whether the data ask for an exponent: its interval and profile, and the same fit without it."""
    exponent = next(entry for entry in found["parameters"] if entry["name"].startswith("growth"))
    key = exponent["keys"][0]
    scale = float(key["before"])
    without = fitted(options, "without-growth", without_growth(options), "oil.toml")
    others = [curve for curve in without["curves"] if curve["run"] in SPEEDS]
    profile = exponent["profile"]
    rises = "; ".join(f"{scale * value:.2f}: {rise:.1f}" for value, rise in zip(profile["values"], profile["rise"]))
    return (f"- **A sink that grows with the speed**: the exponent is {scale * exponent['estimate']:.2f} "
            f"(90 % interval {scale * exponent['lower']:.2f} to {scale * exponent['upper']:.2f}, before "
            f"{scale * exponent['prior_lower']:.2f} to {scale * exponent['prior_upper']:.2f}). Without growth (exponent 0) the "
            f"same fit has {rms(others, 'rms'):.1f} instead of {rms(speeds, 'rms'):.1f} K at the held-out speeds. "
            f"Profile, exponent and rise of twice the cost: {rises}.\n")


def force_verdict(options):
    """Which heat the rises without force ask for."""
    found = fitted(options, "force", os.path.join(PRESS, "calibration-force.toml"))
    load, viscous = (next(entry for entry in found["parameters"] if entry["name"].startswith(name)) for name in ("load", "viscous"))
    fit = [curve for curve in found["curves"] if not curve["held_out"]]
    return (f"- **What the rises without force ask for** (`calibration-force.toml`, fitted at 300 kN and without force): load parts "
            f"{load['estimate']:.2f} times ({load['lower']:.2f} to {load['upper']:.2f}) and viscous parts {viscous['estimate']:.2f} "
            f"times ({viscous['lower']:.2f} to {viscous['upper']:.2f}) those of Table 5, and still {rms(fit, 'rms'):.1f} K rms. "
            "The loads of this linkage and any division of Table 5 into load and speed contradict the printed force sweep.\n")


def paper(options):
    found = fitted(options, "paper", os.path.join(PRESS, "calibration.toml"))
    text = """## The paper's press

`cases/jl75g-60/calibration.toml` fits three oil coefficients, the exponent of their growth with the speed and the heat of
the plain joints to the rises that the paper prints at 200 and 500 rpm. All other operating points are held out. Rises are
at three hours; errors in K. `oil-with-speed.toml`, the case before the fit, assumes the exponent 0.4.

| unknown | value | 90 % interval | before | by the data |
|---|--:|--:|--:|--:|
"""
    for entry in found["parameters"]:
        text += (f"| {entry['name']} | {entry['estimate']:.3g} | {entry['lower']:.3g} to {entry['upper']:.3g} | "
                 f"{entry['prior_lower']:.3g} to {entry['prior_upper']:.3g} | {100 * entry['shrinkage']:.0f} % |\n")
    text += "\nValues are factors on those of `oil-with-speed.toml`.\n\n"
    text += "| runs | values | calibrated | before | no change | mean of fitted runs | in the 90 % band |\n"
    text += "|---|--:|--:|--:|--:|--:|--:|\n"
    of = {}
    for curve in found["curves"]:
        of.setdefault(curve["run"], []).append(curve)
    groups = [("200 and 500 rpm, fitted", [run for run in of if not of[run][0]["held_out"]]),
              ("300 and 400 rpm, held out", SPEEDS), ("0, 100 and 400 kN, held out", FORCES),
              ("bearings of 5e7 and 1e9 N/m, held out", BEARINGS)]
    for name, runs in groups:
        text += group_row(name, [curve for run in runs for curve in of[run]])
    speeds = [curve for run in SPEEDS for curve in of[run]]
    forces = [curve for run in FORCES for curve in of[run]]
    gain = rms(speeds, "rms_of_case") / rms(speeds, "rms")
    none = of["without force"]
    text += "\n### Verdicts\n\n"
    text += (f"- **Other speeds**: the calibrated case is better than the one before by a factor of {gain:.1f} in rms "
             f"({'reached' if gain >= 1.5 else 'not reached'}: 1.5). The mean of both fitted speeds, which needs no model, "
             f"has {rms([c for c in speeds if c['rms_of_mean'] is not None], 'rms_of_mean'):.1f} K.\n")
    model_error = max(curve["model_error"] for curve in found["curves"])
    text += (f"- **The model does not explain the data**: the probability of such residuals is "
             f"{found['model']['probability']:.0e}; a model error of {model_error:.1f} K was added.\n")
    text += growth_verdict(options, found, speeds)
    text += (f"- **Force**: held-out forces have {rms(forces, 'rms'):.1f} K rms. Without force the case predicts rises that "
             f"are {abs(sum(c['bias'] for c in none) / len(none)):.1f} K {'higher' if sum(c['bias'] for c in none) < 0 else 'lower'} "
             "than printed on average: no oil coefficient makes the rises fall with the force as they do in the paper.\n")
    text += force_verdict(options)
    text += ("- **Stiffness of the bearings**: " + (f"{rms([c for run in BEARINGS for c in of[run]], 'rms'):.1f} K rms, against "
             f"{rms([c for run in BEARINGS for c in of[run]], 'rms_of_case'):.1f} K before.\n"))
    text += "\nWhat `deadpoint calibrate` says:\n\n"
    text += "".join(f"> {line}\n>\n" for line in found["conclusions"]).rstrip(">\n") + "\n\n"
    for warning in found["warnings"]:
        text += f"Warning: {warning}.\n\n"
    return text


SYNTHETIC = """## Synthetic presses

The starter press on a coarse mesh (`--size 1.5`, 80 states) is fitted to truths on finer meshes (`--size 1.2` and the mesh of the
case, in turn). Its films are constants. Friction of journals, pins and guides is drawn from its prior (a factor of 1.5), a factor on
both films as well, the room's temperature (1 K) and the bias of one sensor (0.5 K). Three thermometers (0.1 K) and the gap (0.5 um)
give a value each six minutes for three hours. The fit then predicts a duty cycle that was held out: 60, 45 and 55 rpm with a break
and a tool change between, 4 h 20 min. Its errors are root mean squares over all draws, of the gap as a share of its range over the
cycle.

- **Truths**: *same laws*; *other films*: natural convection by law in place of constant films, with radiation; *wrong law*: oil
  takes heat from pins and guides, which the model lacks.
- **What the fit allows for** by alternatives: a *coarser mesh* (`--size 2.25`), and *other films*, one for each surface, by the law of
  a horizontal plate: not the law of the truth. A model error of 0.2 K and 2 um is one that the calibration file states.

The columns of the unknowns say in which share of the draws the interval of 90 % held the true value; by chance alone shares of 200
draws scatter by 2 % (one standard deviation) and shares of 40 draws by 5 %.

"""
RANKS = """
The place of the true value in its posterior, in ten classes, should be uniform. Probability of ranks as uneven by chance:

"""


def starter(options, size):
    return reduced(options, f"starter-{size}.rom", STARTER, ["--size", f"{size * options.size:g}", "--full-runs", "0",
                                                             *settings(["reduce.states=80", "reduce.gap=\"1 um\""])])


def uniform_probability(ranks):
    """Probability of ranks as uneven as these by chance: chi-square with nine degrees of freedom (odd: closed form)."""
    expected = sum(ranks) / len(ranks)
    x = sum((count - expected) ** 2 / expected for count in ranks)
    series = sum(math.sqrt(x) ** (2 * k + 1) / math.prod(range(1, 2 * k + 2, 2)) for k in range(4))
    return math.erfc(math.sqrt(x / 2)) + math.sqrt(2 / math.pi) * math.exp(-x / 2) * series


def coverage_lines(options):
    """What the benchmark prints for each of its lines."""
    model, coarser = starter(options, 1.5), starter(options, 2.25)
    truths = [starter(options, 1.2), starter(options, 1)]
    for number, draws in COVERAGE:
        log = os.path.join(options.scratch, f"coverage-{number}.json")
        if not os.path.exists(log):
            with open(log + "-", "w") as file:
                call([options.benchmark, STARTER, model, coarser, str(min(draws, options.draws)), str(number), *truths], file)
            os.rename(log + "-", log)
        with open(log) as file:
            yield json.load(file)


def shares(line):
    return {entry["name"]: 100 * entry["inside"] / line["draws"] for entry in line["unknowns"]}


def span(line, *without):
    values = [share for name, share in shares(line).items() if name not in without]
    return f"{min(values):.0f} to {max(values):.0f} %"


def findings(lines):
    """What the table shows, in words."""
    none, mesh = lines["same laws, no model error"], lines["same laws, coarser mesh"]
    films, both = lines["other films, coarser mesh"], lines["other films, coarser mesh and other films"]
    wrong = [lines[name] for name in ("wrong law, coarser mesh", "wrong law, coarser mesh and other films",
                                      "wrong law, model error 0.2 K and 2 um stated")]
    noticed = [f"{line['wrong']} of {line['draws']}" for line in wrong]
    return f"""
### What the table shows

- **The mesh**: with the coarser mesh as an alternative the intervals hold {span(mesh)} of the true values (wanted: 85 to 95 %), a right
  model is called wrong in {mesh['wrong']} of {mesh['draws']} draws, a wrong law in {noticed[0]}, and the duty cycle is predicted to
  {mesh['temperature']:.2f} K and {100 * mesh['gap']:.1f} % (wanted: 1 K and 4 %). Without it the pins' intervals hold
  {shares(none)['pins']:.0f} %, those of all unknowns {span(none)}.
- **Films of another law** leave residuals like noise: {films['wrong']} of {films['draws']} draws are called wrong, and the pins'
  intervals hold {shares(films)['pins']:.0f} %. No statistics of the data can show this. Where the calibration file doubts the films, by a
  law that is not that of the truth either, intervals hold {shares(both)['pins']:.0f} % (pins) and {span(both, 'pins')} (others): what
  the doubted law does not resemble is still missing.
- **Every doubt costs power**: a wrong law is noticed in {noticed[0]} draws with the mesh alone, in {noticed[1]} if both films are
  doubted as well, and in {noticed[2]} with a stated model error of its size.
- **A wrong law that is noticed widens intervals, and they still miss**: oil that the model lacks leaves heat where no unknown can
  take it, and all friction moves the same way. The verdict is the result there, not the values.
- **Duty cycles are predicted well by wrong values**: other films change them to {films['temperature']:.2f} K and {100 * films['gap']:.1f} %.
- **Ranks are not uniform** although intervals hold their share: a mesh errs in one direction, the same in all draws of a truth,
  while the fit assumes an error that may have either sign. So the posterior lies to one side of the truth by half a standard
  deviation, within intervals that are wide enough for it.
"""


def coverage(options):
    text = SYNTHETIC + "| truth, and what the fit allows for | draws | called wrong | duty cycle, temperatures | duty cycle, gap | "
    names = ["journals", "pins", "guides", "room", "films", "bias"]
    text += " | ".join(names) + " | mean |\n|---|" + "--:|" * (5 + len(names)) + "\n"
    ranks, lines = "", {}
    for line in coverage_lines(options):
        lines[line["name"]] = line
        draws, of = line["draws"], {entry["name"]: entry for entry in line["unknowns"]}
        cells = [f"{100 * of[name]['inside'] / draws:.0f} %" if name in of else "-" for name in names]
        mean = 100 * sum(entry["inside"] for entry in of.values()) / (draws * len(of))
        text += (f"| {line['name']} | {draws} | {line['wrong']} | {line['temperature']:.2f} K | {100 * line['gap']:.1f} % | "
                 + " | ".join(cells) + f" | {mean:.0f} % |\n")
        if draws >= 100:
            ranks += f"- {line['name']}: " + ", ".join(f"{name} {uniform_probability(of[name]['ranks']):.2g}"
                                                       for name in names if name in of) + "\n"
    return text + findings(lines) + RANKS + ranks


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="write docs/validation/calibration.md")
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "release", "app", "deadpoint"))
    parser.add_argument("--benchmark", default=os.path.join(ROOT, "build", "release", "benchmarks",
                                                            "benchmark_calibration_coverage"))
    parser.add_argument("--scratch", default=os.path.join(ROOT, "build", "calibration"))
    parser.add_argument("--draws", type=int, default=200)
    parser.add_argument("--size", type=float, default=1, help="factor on all cell sizes: a trial")
    options = parser.parse_args()
    os.makedirs(options.scratch, exist_ok=True)
    page = HEAD + paper(options) + coverage(options)
    if options.write:
        with open(DOCUMENT, "w") as file:
            file.write(page)
    else:
        print(page, end="")


if __name__ == "__main__":
    main()
