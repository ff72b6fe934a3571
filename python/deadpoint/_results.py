"""Results of runs and studies."""
from __future__ import annotations

import functools
import json
import pathlib
import shutil
import tempfile
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from deadpoint import _schema
from deadpoint._errors import InputError, IoError, NameUnknown
from deadpoint._series import Array, Named, Series
from deadpoint._tables import Table, TableColumn, Tables, column_of

if TYPE_CHECKING:
    import pandas
    import xarray

    from deadpoint import _reduced
    from deadpoint._fields import Fields
    from deadpoint._plot import Plot

RESULT_FORMAT = 2


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
    def tables(self) -> Tables:
        """All tables: ``history``, ``contributions``, ``gaps`` and so on. Those of a folder are read when first used."""
        if self._run is None:
            return Tables(self.folder)
        found = self._run.tables()
        return Tables(None, {file: Table(file, [column_of(file, *one) for one in found[file]]) for file in found})

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The figures of ``summary.json`` (docs/result-files.md)."""
        if self._run is not None:
            return dict(json.loads(self._run.summary()))
        assert self.folder is not None
        return dict(_json(self.folder / "summary.json"))

    # ---------------------------------------------------------------- series

    @property
    def time(self) -> Array:
        """Times of the rows since the start [s]; shape (n,)."""
        return np.asarray(self.tables["history"]["time"], dtype=float)

    def series(self, kind: str, table: str = "history") -> Named:
        """All series of a kind, by the name of the thing: ``result.series("joint_heat")["crank_pin"]``.

        :param kind: as in docs/result-files.md
        :param table: ``history``, ``contributions`` or ``gaps``
        """
        if table not in self.tables:
            return Named(kind.replace("_", " "), {})
        found = self.tables[table]
        time = np.asarray(found["time"], dtype=float)
        dimensions = _schema.dimensions() if kind == "dimension" else {}
        return Named(
            kind.replace("_", " "),
            {c.name: _series(c, time, dimensions.get(c.name, "")) for c in found.of_kind(kind)},
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
        return str(self.summary["case"]["name"])

    @property
    def case_hash(self) -> str:
        """Hash of the case, equal for equal cases."""
        return str(self.summary["case"]["hash"])

    @property
    def warnings(self) -> list[str]:
        """All warnings of the run."""
        return list(self.summary["warnings"])

    @property
    def interrupted(self) -> bool:
        """True if the run was stopped before its end."""
        return bool(self.summary["interrupted"])

    @property
    def error(self) -> StatedError | None:
        """How far a reduced run is off the large model; None for a full run, and if it was not estimated."""
        found = self.summary.get("reduced", {}).get("estimate")
        return StatedError(found["of"], found["temperature_K"], found["E_SW_um"]) if found else None

    @property
    def outside(self) -> list[str]:
        """Coefficients outside the range for which the reduced model was built: the run is then an extrapolation."""
        return list(self.summary.get("reduced", {}).get("outside", []))

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
        time = groups.pop("time")[0]
        data: dict[str, Any] = {}
        for kind, columns in groups.items():
            attributes = {"units": columns[0].unit, "long_name": columns[0].meaning}
            named = any(column.name != column.heading or kind == "probe_temperature" for column in columns)
            if len(columns) > 1 or named or kind == "dimension":
                values = np.array([column.values for column in columns])
                data[kind] = ((f"{kind}_name", "time"), values, attributes)
            else:
                data[kind] = (("time",), columns[0].values, attributes)
        coordinates: dict[str, Any] = {"time": ("time", time.values, {"units": "s"})}
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

        return np.array([time for time, _ in listed(self.folder)])

    def fields(self, time: float | None = None) -> Fields:
        """Temperature, displacement and stress on the mesh at one of :attr:`field_times`.

        :param time: [s]; None: the last one
        :raises deadpoint.InputError: if the folder holds no fields, or none at this time
        """
        from deadpoint._fields import fields_at

        return fields_at(self.folder, time)

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
        target = pathlib.Path(folder)
        self._run.write(target, replace)
        if self.folder is not None:
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

        return result_html(self)


def _series(column: TableColumn, time: Array, meaning: str) -> Series:
    full = f"{column.meaning}: {meaning}" if meaning else column.meaning
    return Series(column.name, column.kind, column.unit, full, time, np.asarray(column.values, dtype=float))


class Study:
    """A folder that ``sweep``, ``sensitivity``, ``optimise``, ``calibrate``, ``loads`` or ``heat`` wrote."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder
        """Where it is."""
        self.tables = Tables(folder)
        """All tables by name: ``study.tables["parameters"]``."""

    @functools.cached_property
    def figures(self) -> dict[str, Any]:
        """The JSON files of the folder by name without ending: ``study.figures["calibration"]``."""
        skipped = {"deadpoint", "motion", "view"}
        return {
            path.stem: _json(path) for path in sorted(self.folder.glob("*.json")) if path.stem not in skipped
        }

    @property
    def page(self) -> pathlib.Path:
        """The page with all charts."""
        return self.folder / "report.html"

    def __iter__(self) -> Iterator[Result]:
        """Results of the runs in its subfolders."""
        for path in sorted(self.folder.rglob("summary.json")):
            yield open_result(path.parent)

    def to_pandas(self, table: str) -> pandas.DataFrame:
        """A table as a data frame. Needs pandas."""
        return self.tables[table].to_pandas()

    def __repr__(self) -> str:
        return f"<Study in '{self.folder}': {', '.join([*self.tables, *self.figures])}>"

    def _repr_html_(self) -> str:
        from deadpoint._html import study_html

        return study_html(self)


def _json(path: pathlib.Path) -> Any:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise IoError(f"cannot read '{path}': {error.strerror}") from error
    except ValueError as error:
        raise InputError(f"'{path}' was changed or cut short: {error}\n  help: compute it again") from error


def _require_folder(folder: pathlib.Path) -> None:
    if not folder.is_dir():
        raise IoError(f"there is no folder '{folder}'\n  help: give the folder that 'deadpoint run -o' wrote")
    manifest = folder / "deadpoint.json"
    if not manifest.exists():
        raise InputError(f"'{folder}' holds no results of deadpoint: deadpoint.json is missing\n"
                         "  help: give the folder itself, not one above it")
    found = _json(manifest)
    if not isinstance(found, dict) or found.get("format") != RESULT_FORMAT:
        raise InputError(f"'{folder}' is a result of another format\n  help: compute it again with this version")


def open_result(folder: pathlib.Path) -> Result:
    """The result of a run in a folder."""
    return Result(folder)


def open(folder: str | pathlib.Path) -> Result:
    """Opens a folder that ``deadpoint run`` wrote.

    :raises deadpoint.IoError: if there is no such folder
    :raises deadpoint.InputError: if deadpoint did not write it, an older version did, or it is one of another command
    """
    path = pathlib.Path(folder)
    _require_folder(path)
    if not (path / "summary.json").exists():
        raise InputError(f"'{path}' holds no run\n  help: open the folder of another command with deadpoint.open_study()")
    return open_result(path)


def open_study(folder: str | pathlib.Path) -> Study:
    """Opens a folder that ``sweep``, ``sensitivity``, ``optimise``, ``calibrate``, ``loads`` or ``heat`` wrote.

    :raises deadpoint.IoError: if there is no such folder
    :raises deadpoint.InputError: if deadpoint did not write it, or an older version did
    """
    path = pathlib.Path(folder)
    _require_folder(path)
    return Study(path)
