"""Studies with the verbs of the command line. Each writes a folder and opens it."""
from __future__ import annotations

import json
import pathlib
import tempfile
from collections.abc import Mapping, Sequence
from typing import Any

from deadpoint._command import call, case_arguments
from deadpoint._errors import path_of, reading, writing
from deadpoint._press import Press, Setting, _text_of, press_of
from deadpoint._results import Study, open_study
from deadpoint._rom import Rom


def _model(reduced: Rom | str | pathlib.Path | None) -> list[Any]:
    if reduced is None:
        return []
    return ["--reduced", reduced.file if isinstance(reduced, Rom) else reduced]


def _options(output: str | pathlib.Path, replace: bool, jobs: int | None) -> list[Any]:
    return ["-o", output, *(["--force"] if replace else []), *(["-j", jobs] if jobs else [])]


def _flags(**flags: bool) -> list[str]:
    return ["--" + name.replace("_", "-") for name, on in flags.items() if on]


def sweep(study: str | pathlib.Path | Press, output: str | pathlib.Path,
          axes: Mapping[str, Sequence[Setting]] | None = None, reduced: Rom | str | pathlib.Path | None = None,
          size: float | None = None, jobs: int | None = None, progress: bool = False) -> Study:
    """Runs many cases, as ``deadpoint sweep`` does; iterate over the study for the results of full runs.

    :param study: a study file, or a press whose keys ``axes`` vary
    :param output: the folder, new or of the same study, which then continues
    :param axes: keys and their values; all combinations are computed
    :param reduced: computes on this reduced model
    :param size: factor on all cell sizes
    :param jobs: runs at a time
    """
    more = [*_model(reduced), "-o", output, *(["--size", size] if size else []), *(["-j", jobs] if jobs else [])]
    if not isinstance(study, Press):
        call("sweep", [study, *more], progress)
        return open_study(path_of(output))
    with writing("temporary folder"), tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "study.toml"
        file.write_text(_study_text(study, axes or {}), encoding="utf-8")
        call("sweep", [file, *more, *_flags(allow_outside=study.allow_outside)], progress)
    return open_study(path_of(output))


def _study_text(press: Press, axes: Mapping[str, Sequence[Setting]]) -> str:
    settings = [f"{key}={value}" for key, value in press.settings.items()]
    lines = ["format = 1", 'name = "sweep"', f"base = {json.dumps(str(press.file.resolve()))}", f"set = {json.dumps(settings)}",
             "[[sets]]", 'name = "sweep"']
    for key, values in axes.items():
        lines += ["[[sets.axes]]", f"key = {json.dumps(key)}", f"values = {json.dumps([_text_of(value) for value in values])}"]
    return "\n".join(lines) + "\n"


def calibrate(case: Press | str | pathlib.Path, calibration: str | pathlib.Path, output: str | pathlib.Path,
              reduced: Rom | str | pathlib.Path | None = None, plan: bool = False, full_run: bool = False,
              replace: bool = False, jobs: int | None = None, progress: bool = False) -> Study:
    """Finds unknown values of a case from measurements, as ``deadpoint calibrate`` does (docs/calibration.md).

    :param calibration: the calibration file
    :param output: the folder; its file ``calibrated.toml`` has the values
    :param reduced: the reduced model, if the calibration file names none
    :param plan: say what planned measurements can determine, instead
    :param full_run: check the calibrated case by a full run
    """
    arguments = [*case_arguments(press_of(case)), calibration, *_model(reduced), *_options(output, replace, jobs)]
    call("calibrate", [*arguments, *_flags(plan=plan, full_run=full_run)], progress)
    return open_study(path_of(output))


def sensitivity(study: str | pathlib.Path, reduced: Rom | str | pathlib.Path, output: str | pathlib.Path,
                replace: bool = False, jobs: int | None = None, progress: bool = False) -> Study:
    """Finds which unknowns matter when all vary together, as ``deadpoint sensitivity`` does.

    :param study: a study file with a section [sensitivity]
    """
    call("sensitivity", [study, *_model(reduced), *_options(output, replace, jobs)], progress)
    return open_study(path_of(output))


def optimise(study: str | pathlib.Path, reduced: Rom | str | pathlib.Path, output: str | pathlib.Path,
             full_run: bool = True, replace: bool = False, jobs: int | None = None, progress: bool = False) -> Study:
    """Finds the values with the shortest warm-up or the least drift, as ``deadpoint optimise`` does.

    :param study: a study file with a section [optimise]
    :param full_run: also compute the optimum in full
    """
    arguments = [study, *_model(reduced), *_options(output, replace, jobs), *_flags(no_full_run=not full_run)]
    call("optimise", arguments, progress)
    return open_study(path_of(output))


def compare(results: str | pathlib.Path, reference: str | pathlib.Path, point: str | None = None) -> dict[str, Any]:
    """Compares a result folder with measured or published values, as ``deadpoint compare`` does.

    :param results: a folder that a run has written
    :param reference: a reference file
    :param point: operating point of the reference; None: values without one
    :returns: the contents of ``compare.json`` (docs/result-files.md), and under ``text`` the tables
    """
    with writing("temporary folder"), tempfile.TemporaryDirectory() as folder:
        target = pathlib.Path(folder) / "compare"
        text = call("compare", [results, reference, "-o", target, *(["--point", point] if point else [])], False)
        with reading("compare.json"):
            found = json.loads(target.with_suffix(".json").read_text(encoding="utf-8"))
    return {**found, "text": text}
