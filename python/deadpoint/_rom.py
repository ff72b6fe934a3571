"""The reduced press: runs in milliseconds, without a mesh."""
from __future__ import annotations

import itertools
import math
import os
import pathlib
import warnings
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from deadpoint import _reduced
from deadpoint._errors import InputError, Interrupted, path_of, unknown
from deadpoint._press import Press, Setting, _text_of, press_of
from deadpoint._progress import Receiver, close, receiver_of
from deadpoint._results import Result, StatedError
from deadpoint._series import Array

if TYPE_CHECKING:
    import pandas

_KINDS = ("film", "side", "oil", "heat", "oil temperature", "ambient")
_MICROMETRE = 1e6
_ZERO_CELSIUS = 273.15
MOST_RUNS = 1_000_000  # of one map


def _threads(wanted: int | None) -> int:
    return max(wanted or os.cpu_count() or 1, 1)


class Range(NamedTuple):
    """A coefficient that is free in a reduced model."""

    name: str
    """Key of the case."""
    kind: str
    """``film``, ``side``, ``oil``, ``heat``: a factor; ``oil temperature``, ``ambient``: a difference [K]."""
    low: float
    """The model was built for values from here"""
    high: float
    """to here."""


class Output(NamedTuple):
    """A curve that a reduced run has."""

    name: str
    """Name of a probe, a dimension or a corner."""
    unit: str
    """``degC`` or ``um``."""


class Sensitivity(NamedTuple):
    """How the figures at the end depend on one coefficient."""

    coefficient: str
    """Key of the case."""
    value: float
    """In the first segment; 1 for a factor on several values [unit]."""
    unit: str
    """Empty: a factor."""
    change: float
    """To which effects refer: a tenth of the value, or 1 K [unit]."""
    gap: float
    """Derivative of E_SW [um per unit]."""
    probes: dict[str, float]
    """Derivative of each probe [K per unit]."""


class Derivatives(NamedTuple):
    """Curves of a run and their derivatives."""

    time: Array
    """Times of the steps [s]; shape (n,)."""
    values: dict[str, Array]
    """Curves by name: probes [degC], dimensions [um]; shape (n,)."""
    by: dict[str, dict[str, Array]]
    """``by[key][curve]``: derivative by the relative change of the key [K or um per 1, that is per 100 %], or per kelvin."""


class Map(NamedTuple):
    """Figures of many runs; each array has one axis for each changed key."""

    axes: dict[str, list[Setting]]
    """Keys and their values, in the order of the arrays' axes."""
    gap_end: Array
    """E_SW at the end [um]; not a number without a dimension chain and where a run failed."""
    gap_largest: Array
    """E_SW of largest magnitude [um]."""
    warm_up: Array
    """Time from which E_SW moves more slowly than ``chain.drift_rate_limit`` [s]; not a number if it never does."""
    probes: dict[str, Array]
    """Temperature of each probe at the end [degC]."""
    errors: list[str]
    """Why runs failed, each once."""
    warnings: list[str]
    """Warnings of all runs, each once."""

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each run. Needs pandas."""
        import pandas

        rows: dict[str, Any] = {
            key: [point[k] for point in itertools.product(*self.axes.values())] for k, key in enumerate(self.axes)
        }
        rows.update({"E_SW end [um]": self.gap_end.ravel(), "E_SW largest [um]": self.gap_largest.ravel(),
                     "warm-up [s]": self.warm_up.ravel()})
        rows.update({f"{name} end [degC]": values.ravel() for name, values in self.probes.items()})
        return pandas.DataFrame(rows)


class Rom:
    """A reduced press, from ``deadpoint reduce`` or :meth:`deadpoint.Press.reduce`. Made by :func:`deadpoint.open_rom`.

    Several threads may run one model, or several models, at once.
    """

    def __init__(self, file: str | pathlib.Path) -> None:
        self.file = path_of(file)
        """The file of the model."""
        self._model = _reduced.Rom(self.file)
        self._info = self._model.info()
        self._large: _reduced.Rom | None = None

    # ---------------------------------------------------------------- what it is

    @property
    def name(self) -> str:
        """Name of the case that was reduced."""
        return self._info["name"]

    @property
    def case_hash(self) -> str:
        """Hash of the case that was reduced."""
        return self._info["case_hash"]

    @property
    def states(self) -> int:
        """Number of states."""
        return self._info["states"]

    @property
    def parts(self) -> list[str]:
        """Names of the parts."""
        return list(self._info["parts"])

    @property
    def interfaces(self) -> list[str]:
        """Names of the interfaces: ``joint.interface``."""
        return list(self._info["interfaces"])

    @property
    def ranges(self) -> list[Range]:
        """The free coefficients with the ranges for which the model was built."""
        return [Range(name, _KINDS[kind], low, high) for name, kind, low, high in self._info["box"]]

    @property
    def errors(self) -> list[StatedError]:
        """Errors that were measured when the model was built."""
        return [StatedError(of, temperature, _MICROMETRE * gap) for of, temperature, gap in self._info["errors"]]

    def outputs(self, case: Press | str | pathlib.Path) -> list[Output]:
        """The curves of a run of a case: probes [degC], dimensions and corners [um]."""
        found = self._model.outputs(press_of(case).case)
        return [Output(name, "degC" if kind == "probe" else "um") for kind, name in found]

    def misfits(self, case: Press | str | pathlib.Path) -> list[str]:
        """How a case differs in what a reduced model cannot change; empty if it fits."""
        return self._model.misfits(press_of(case).case)

    # ---------------------------------------------------------------- runs

    def run(self, case: Press | str | pathlib.Path, settings: Mapping[str, Setting] | None = None,
            estimate: bool = True, causes: bool = True, progress: bool | Receiver = False) -> Result:
        """Computes a case on the reduced model, as ``deadpoint run --reduced`` does.

        Operation, ambient, oil, friction, conductances and convection may differ from the case that was reduced.

        :param case: a press or the file of a case
        :param settings: further changes by key, for this run only
        :param estimate: also compute the large model beside the file; the difference is ``result.error``
        :param causes: also attribute the drift to heat sources, and compute the vibration of the crankshaft
        :raises deadpoint.InputError: if the case is not the press that was reduced
        :raises deadpoint.Interrupted: after Ctrl-C; its ``result`` has the run up to then
        """
        press = press_of(case)
        if settings:
            press = press.changed(settings)
        large = self._large_model() if estimate else None
        receiver = receiver_of(progress)
        try:
            run = self._model.run(press.case, large, not causes, receiver)
        finally:
            close(receiver)
        result = Result(run=run)
        if run.interrupted:
            raise Interrupted(result)
        return result

    def _large_model(self) -> _reduced.Rom | None:
        if self._large is None and self._info["large_file"]:
            file = self.file.parent / self._info["large_file"]
            if file.exists():
                self._large = _reduced.Rom(file)
            else:
                warnings.warn(f"'{file}' is missing, so the error of this run is not estimated", stacklevel=3)
        return self._large

    def map(self, case: Press | str | pathlib.Path, axes: Mapping[str, Sequence[Setting]], threads: int | None = None,
            progress: bool | Receiver = False) -> Map:
        """Runs all combinations of the values of some keys, several at once, and keeps their figures.

        :param axes: keys and their values: ``{"operation.0.speed": ["200 rpm", "300 rpm"]}``
        :param threads: runs at a time; None: as many as processors
        :returns: arrays of the shape (values of the first key, values of the second key, ...)
        :raises deadpoint.Interrupted: after Ctrl-C; its ``result`` has the runs up to then
        """
        press = press_of(case)
        shape = tuple(len(values) for values in axes.values())
        if not all(shape):
            raise InputError("a key of a map has no value\n  help: give at least one")
        if math.prod(shape) > MOST_RUNS:
            raise InputError(f"a map of {math.prod(shape)} runs is too large\n  help: give fewer values; {MOST_RUNS} runs are the most")
        texts = [[f"{key}={_text_of(value)}" for value in values] for key, values in axes.items()]
        points = [list(point) for point in itertools.product(*texts)]
        receiver = receiver_of(progress)
        try:
            found = self._model.map(press.case, points, _threads(threads), receiver)
        finally:
            close(receiver)
        result = Map(
            {key: list(values) for key, values in axes.items()},
            _MICROMETRE * found["gap_end"].reshape(shape),
            _MICROMETRE * found["gap_largest"].reshape(shape),
            found["warm_up"].reshape(shape),
            {name: values.reshape(shape) - _ZERO_CELSIUS for name, values in found["probes"].items()},
            list(dict.fromkeys(error for error in found["errors"] if error)),
            found["warnings"],
        )
        if found["interrupted"]:
            raise Interrupted(result)
        return result

    # ---------------------------------------------------------------- derivatives

    def sensitivities(self, case: Press | str | pathlib.Path) -> list[Sensitivity]:
        """How the figures at the end depend on every free coefficient, speed and force; the strongest first.

        The same as ``deadpoint run --reduced --sensitivities``.
        """
        found = self._model.sensitivities(press_of(case).case, None)
        probes = found["probes"]
        return [
            Sensitivity(name, value, unit, change, _MICROMETRE * gap, dict(zip(probes, temperatures)))
            for name, value, unit, change, gap, temperatures in found["rows"]
        ]

    def derivatives(self, case: Press | str | pathlib.Path, keys: Sequence[str], shifts: Sequence[str] = (),
                    threads: int | None = None) -> Derivatives:
        """A run with the derivatives of all its curves by keys of the case, exact for its time steps.

        :param keys: keys or patterns (``friction.*.load_part``) whose values change by a factor
        :param shifts: keys of temperatures and the like, whose values change by a difference
        """
        press = press_of(case)
        wanted = [(key, [key], False) for key in keys] + [(key, [key], True) for key in shifts]
        if not wanted:
            raise InputError("there is no key to derive by\n  help: give at least one")
        time, values, slopes = self._model.derivatives(press.case, wanted, _threads(threads))
        outputs = self.outputs(press)
        curves = {
            output.name: value - _ZERO_CELSIUS if output.unit == "degC" else _MICROMETRE * value
            for output, value in zip(outputs, values)
        }
        by = {
            key[0]: {
                output.name: np.asarray(slope) * (1.0 if output.unit == "degC" else _MICROMETRE)
                for output, slope in zip(outputs, row)
            }
            for key, row in zip(wanted, slopes)
        }
        return Derivatives(time, curves, by)

    def gradient(self, case: Press | str | pathlib.Path, keys: Sequence[str], shifts: Sequence[str] = (),
                 of: str = "E_SW", time: float | None = None) -> dict[str, float]:
        """The gradient of one curve at one time.

        :param keys: keys or patterns whose values change by a factor
        :param shifts: keys whose values change by a difference
        :param of: name of a dimension or a probe
        :param time: since the start [s]; None: the end
        :returns: by key, per relative change (per 1, that is per 100 %) or per kelvin: [um] or [K]
        """
        found = self.derivatives(case, keys, shifts)
        if of not in found.values:
            raise unknown("curve", of, found.values)
        at = float(found.time[-1] if time is None else time)
        if not found.time[0] <= at <= found.time[-1]:
            raise InputError(f"{at:g} s is outside the run\n  help: it has {found.time[0]:g} to {found.time[-1]:g} s")
        return {key: float(np.interp(at, found.time, curves[of])) for key, curves in found.by.items()}

    def __repr__(self) -> str:
        return f"<Rom of '{self.name}': {self.states} states, '{self.file}'>"


def open_rom(file: str | pathlib.Path) -> Rom:
    """Opens a reduced press.

    :param file: written by ``deadpoint reduce``: ``press.rom``
    :raises deadpoint.IoError: if it cannot be read, is of another format, was cut short or changed
    """
    return Rom(file)
