"""Results of runs and studies."""
from __future__ import annotations

import functools
import json
import math
import operator
import pathlib
import shutil
import tempfile
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from deadpoint import _reduced, _schema
from deadpoint._errors import InputError, NameUnknown, path_of, reading, writing
from deadpoint._series import Array, Named, Series
from deadpoint._tables import Table, TableColumn, Tables, column_of, needed

if TYPE_CHECKING:
    import pandas
    import xarray

    from deadpoint._fields import Fields
    from deadpoint._plot import Plot


class StatedError(NamedTuple):
    """How far a reduced run is off, or may be."""

    of: str
    """What was compared: ``this run, to the large model``."""
    temperature: float
    """Largest difference of probes and joints after the first minute [K]."""
    gap: float
    """The same of E_SW [um]."""


class Result:
    """What a run computed: series by name, tables, figures, charts and fields.

    Units are those of the result files: temperatures in degC, dimensions in um, heat in W, forces in kN, time in s. Each
    series carries its unit and meaning. A result comes from :func:`deadpoint.open`, :meth:`deadpoint.Press.run` or
    :meth:`deadpoint.Rom.run`.
    """

    def __init__(self, folder: pathlib.Path | None = None, run: _reduced.Run | None = None) -> None:
        self.folder = folder
        """Folder of the result; None for a reduced run."""
        self._run = run
        self.temporary: tempfile.TemporaryDirectory[str] | None = None
        """Holds the folder of a run without one; it is removed with the result."""

    @functools.cached_property
    def _files(self) -> _reduced.Files | None:
        """What the folder lists. Each file is compared with its size and checksum when it is read."""
        return _reduced.Files(self.folder) if self.folder else None

    @functools.cached_property
    def tables(self) -> Tables:
        """All tables: ``history``, ``contributions``, ``gaps`` and so on. Those of a folder are read when first used."""
        if self._run is None:
            return Tables(self._files)
        found = self._run.tables()
        return Tables(None, {file: Table(file, [column_of(file, *one) for one in found[file]]) for file in found})

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The figures of ``summary.json`` (docs/result-files.md)."""
        if self._run is not None:
            return dict(json.loads(self._run.summary()))
        assert self._files is not None
        with reading("summary.json"):
            return dict(_json(needed(self._files, "summary.json")))

    def _stated(self, *keys: str) -> Any:
        """A figure of the summary that every run has."""
        with reading("summary.json"):
            return functools.reduce(operator.getitem, keys, self.summary)

    # ---------------------------------------------------------------- series

    @property
    def time(self) -> Array:
        """Times of the rows since the start [s]; shape (n,)."""
        return _time_of(self.tables["history"])

    def series(self, kind: str, table: str = "history") -> Named:
        """All series of a kind, by the name of the thing: ``result.series("joint_heat")["crank_pin"]``.

        :param kind: as in docs/result-files.md
        :param table: ``history``, ``contributions`` or ``gaps``
        """
        if table not in self.tables:
            return Named(kind.replace("_", " "), {})
        found = self.tables[table]
        time = _time_of(found)
        dimensions = _schema.dimensions() if kind == "dimension" else {}
        return Named(
            kind.replace("_", " "),
            {c.name: _series(found.file, c, time, dimensions.get(c.name, "")) for c in found.of_kind(kind)},
        )

    @property
    def gap(self) -> Series:
        """E_SW: change of the gap between slide and table since the start [um]; above zero it opens.

        :raises deadpoint.InputError: if the case has no dimension chain
        """
        if "E_SW" not in self.dimensions:
            raise NameUnknown("the result has no gap: the case has no dimension chain\n  help: add [chain] to the case")
        return self.dimensions["E_SW"]

    @functools.cached_property
    def probes(self) -> Named:
        """Temperatures of the probes [degC]."""
        return self.series("probe_temperature")

    @functools.cached_property
    def joint_temperatures(self) -> Named:
        """Mean temperature of both sides of each joint [degC]."""
        return self.series("joint_temperature")

    @functools.cached_property
    def joint_heat(self) -> Named:
        """Friction heat of each joint, of the whole press [W]."""
        return self.series("joint_heat")

    @functools.cached_property
    def dimensions(self) -> Named:
        """Changes of the dimensions of the chain [um]: E_SW, E_BG, E_WG, E_CS, E_BC."""
        return self.series("dimension")

    @functools.cached_property
    def contributions(self) -> Named:
        """Contribution of each part's warming to E_SW [um]; they sum to E_SW."""
        return self.series("part_share", "contributions")

    @functools.cached_property
    def corners(self) -> Named:
        """Change of the gap at each corner of the slide [um]."""
        return self.series("corner_gap", "gaps")

    @functools.cached_property
    def clearances(self) -> Named:
        """Change of each clearance [um]; below zero it closes."""
        return self.series("clearance", "gaps")

    # ---------------------------------------------------------------- figures

    @property
    def name(self) -> str:
        """The case's own name."""
        return str(self._stated("case", "name"))

    @property
    def case_hash(self) -> str:
        """Hash of the case, equal for equal cases."""
        return str(self._stated("case", "hash"))

    @property
    def warnings(self) -> list[str]:
        """All warnings of the run."""
        with reading("summary.json"):
            return [str(text) for text in self._stated("warnings")]

    @property
    def interrupted(self) -> bool:
        """True if the run was stopped before its end."""
        return bool(self._stated("interrupted"))

    @property
    def error(self) -> StatedError | None:
        """How far a reduced run is off the large model; None for a full run, and if it was not estimated."""
        with reading("summary.json"):
            found = self.summary.get("reduced", {}).get("estimate")
            return StatedError(str(found["of"]), float(found["temperature_K"]), float(found["E_SW_um"])) if found else None

    @property
    def outside(self) -> list[str]:
        """Coefficients outside the range for which the reduced model was built: the run is then an extrapolation."""
        with reading("summary.json"):
            return [str(text) for text in self.summary.get("reduced", {}).get("outside", [])]

    # ---------------------------------------------------------------- other forms

    def to_pandas(self, table: str = "history") -> pandas.DataFrame:
        """A table as a data frame with the time as its index. Needs pandas."""
        frame = self.tables[table].to_pandas()
        return frame.set_index("time [s]") if "time [s]" in frame else frame

    def to_xarray(self) -> xarray.Dataset:
        """The history as a dataset over ``time``: ``probe_temperature(probe_temperature_name, time)`` and so on, each
        with its unit and meaning as attributes. Needs xarray."""
        import xarray

        groups: dict[str, list[TableColumn]] = {}
        for column in self.tables["history"].columns:
            groups.setdefault(column.kind, []).append(column)
        groups.pop("time", None)
        data: dict[str, Any] = {}
        for kind, columns in groups.items():
            attributes = {"units": columns[0].unit, "long_name": columns[0].meaning}
            named = any(column.name != column.heading or kind == "probe_temperature" for column in columns)
            if len(columns) > 1 or named or kind == "dimension":
                values = np.array([column.values for column in columns])
                data[kind] = ((f"{kind}_name", "time"), values, attributes)
            else:
                data[kind] = (("time",), columns[0].values, attributes)
        coordinates: dict[str, Any] = {"time": ("time", self.time, {"units": "s"})}
        for kind, entry in data.items():
            if len(entry[0]) > 1:
                coordinates[f"{kind}_name"] = [column.name for column in groups[kind]]
        return xarray.Dataset(data, coordinates, {"case": self.name, "hash": self.case_hash})

    @property
    def plot(self) -> Plot:
        """Charts: ``result.plot.drift()``, ``.temperatures()``, ``.contributions()``. Needs matplotlib."""
        from deadpoint._plot import Plot

        return Plot(self)

    @property
    def field_times(self) -> Array:
        """Times at which the folder holds fields [s]; shape (m,)."""
        from deadpoint._fields import listed

        return np.array([time for time, _ in listed(self._files)])

    def fields(self, time: float | None = None) -> Fields:
        """Temperature, displacement and stress on the mesh at one of :attr:`field_times`.

        :param time: [s]; None: the last one
        :raises deadpoint.InputError: if the folder holds no fields, or none at this time
        """
        from deadpoint._fields import fields_at

        return fields_at(self._files, time)

    def to_pyvista(self, time: float | None = None) -> Any:
        """The fields as a grid of PyVista. Needs pyvista."""
        return self.fields(time).to_pyvista()

    def save(self, folder: str | pathlib.Path, replace: bool = False) -> Result:
        """Writes the files of ``deadpoint run`` with their page, and opens them.

        :param folder: must not exist, or must be a result folder and ``replace`` true
        :raises deadpoint.IoError: if it cannot be written
        """
        if self._run is None:
            raise InputError(f"this result is in '{self.folder}' already\n  help: copy the folder")
        target = path_of(folder)
        self._run.write(target, replace)
        if self.folder is not None:
            with writing(target):
                shutil.copytree(self.folder, target, dirs_exist_ok=True)  # fields, which are on disk only
        return open_result(target)

    # ---------------------------------------------------------------- text

    def __repr__(self) -> str:
        return f"<Result of '{self.name}': {self._headline()}>"

    def _headline(self) -> str:
        hours = self.time[-1] / 3600
        parts = [f"{hours:.2f} h"]
        if self.dimensions:
            parts.append(f"E_SW {self.gap.end:+.2f} um at the end, {self.gap.largest:+.2f} um at most")
        if self.interrupted:
            parts.append("interrupted")
        return ", ".join(parts)

    def _repr_html_(self) -> str:
        from deadpoint._html import result_html

        with reading("the result"):
            return result_html(self)


def _numbers(file: str, column: TableColumn) -> Array:
    if isinstance(column.values, list):
        raise InputError(f"'{file}' was changed: the column '{column.heading}' has texts or values that are not finite\n"
                         "  help: compute it again")
    return np.asarray(column.values, dtype=float)


def _time_of(table: Table) -> Array:
    """Times of a table, which increase from row to row; the checksum shows only that they are as written."""
    columns = table.of_kind("time")
    if len(columns) != 1 or not len(table):
        raise InputError(f"'{table.file}' was changed: it has no times\n  help: compute it again")
    time = _numbers(table.file, columns[0])
    if np.isnan(time).any() or (np.diff(time) <= 0).any():
        raise InputError(f"'{table.file}' was changed: its times do not increase\n  help: compute it again")
    return time


def _series(file: str, column: TableColumn, time: Array, meaning: str) -> Series:
    full = f"{column.meaning}: {meaning}" if meaning else column.meaning
    return Series(column.name, column.kind, column.unit, full, time, _numbers(file, column))


class Study:
    """A folder that ``sweep``, ``sensitivity``, ``optimise``, ``calibrate``, ``loads`` or ``heat`` wrote."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder
        """Where it is."""
        self._files = _opened(folder)
        self.tables = Tables(self._files)
        """All tables by name: ``study.tables["parameters"]``."""

    @functools.cached_property
    def figures(self) -> dict[str, Any]:
        """The JSON files of the folder by name without ending: ``study.figures["calibration"]``."""
        skipped = {"motion.json", "view.json", "tables.json"}
        found: dict[str, Any] = {}
        for name in self._files.names:
            if name.endswith(".json") and "/" not in name and name not in skipped:
                with reading(name):
                    found[name.removesuffix(".json")] = _json(needed(self._files, name))
        return found

    @property
    def page(self) -> pathlib.Path:
        """The page with all charts."""
        return self.folder / "report.html"

    def __iter__(self) -> Iterator[Result]:
        """Results of the runs in its subfolders."""
        with reading(self.folder):
            folders = sorted(path.parent for path in self.folder.rglob("summary.json"))
        for folder in folders:
            yield open(folder)

    def to_pandas(self, table: str) -> pandas.DataFrame:
        """A table as a data frame. Needs pandas."""
        return self.tables[table].to_pandas()

    def __repr__(self) -> str:
        return f"<Study in '{self.folder}': {', '.join([*self.tables, *self.figures])}>"

    def _repr_html_(self) -> str:
        from deadpoint._html import study_html

        with reading("the study"):
            return study_html(self)


def _finite(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"{text} is not a finite number")
    return value


def _json(data: bytes) -> Any:
    """A document without numbers that are not finite."""
    return json.loads(data.decode("utf-8"), parse_float=_finite, parse_constant=_finite)


def _opened(folder: pathlib.Path) -> _reduced.Files:
    """The list of a folder, whose files are all there as they were written."""
    files = _reduced.Files(folder)
    files.check()
    return files


def open_result(folder: pathlib.Path) -> Result:
    """The result of a run in a folder."""
    files = _opened(folder)
    if "summary.json" not in files.names:
        raise InputError(f"'{folder}' holds no run\n  help: open the folder of another command with deadpoint.open_study()")
    return Result(folder)


def open(folder: str | pathlib.Path) -> Result:
    """Opens a folder that ``deadpoint run`` wrote. All its files must be there as they were written: the sizes are compared at
    once, and the checksums of all but the large ones (fields and states), which are compared when they are read.

    :raises deadpoint.IoError: if there is no such folder, or one of its files is missing or cannot be read
    :raises deadpoint.InputError: if deadpoint did not write it or is not done with it, an older version wrote it, one of its
        files was changed since, or it is a folder of another command
    """
    return open_result(path_of(folder))


def open_study(folder: str | pathlib.Path) -> Study:
    """Opens a folder that ``sweep``, ``sensitivity``, ``optimise``, ``calibrate``, ``loads`` or ``heat`` wrote.

    :raises deadpoint.IoError: as :func:`open`
    :raises deadpoint.InputError: as :func:`open`
    """
    return Study(path_of(folder))
