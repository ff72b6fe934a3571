"""Fields of a run on its mesh, from the VTU files of a result folder."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from deadpoint._errors import InputError, reading, unknown

if TYPE_CHECKING:
    from deadpoint import _reduced


class Fields:
    """Temperature, displacement and stress at one time, as arrays.

    ``fields["temperature [degC]"]`` has shape (points,), ``fields["displacement [mm]"]`` (points, 3), and ``fields["part"]``
    (cells,).
    """

    def __init__(self, time: float, points: npt.NDArray[np.float64], connectivity: npt.NDArray[np.uint32],
                 offsets: npt.NDArray[np.uint32], types: npt.NDArray[np.uint8], point_data: dict[str, npt.NDArray[Any]],
                 cell_data: dict[str, npt.NDArray[Any]]) -> None:
        self.time = time
        """Since the start of the run [s]."""
        self.points = points
        """Places of the points [m]; shape (points, 3)."""
        self.connectivity = connectivity
        """Points of all cells, cell after cell."""
        self.offsets = offsets
        """End of each cell in ``connectivity``; shape (cells,)."""
        self.types = types
        """Type of each cell by VTK's numbers: 10 tetrahedron, 12 hexahedron; shape (cells,)."""
        self.point_data = point_data
        """Arrays at the points, by name with unit."""
        self.cell_data = cell_data
        """Arrays of the cells: number of part and body."""

    @property
    def cells(self) -> npt.NDArray[np.uint32]:
        """Points of each cell; shape (cells, 4) or (cells, 8).

        :raises deadpoint.InputError: if the mesh has cells of both kinds; use ``connectivity`` and ``offsets``
        """
        sizes = np.diff(self.offsets, prepend=np.uint32(0))
        if len(sizes) and (sizes != sizes[0]).any():
            raise InputError("the cells have different numbers of points\n  help: use connectivity, offsets and types")
        return self.connectivity.reshape(len(self.offsets), -1)

    @property
    def temperature(self) -> npt.NDArray[Any]:
        """[degC]; shape (points,)."""
        return self["temperature [degC]"]

    @property
    def displacement(self) -> npt.NDArray[Any]:
        """[mm]; shape (points, 3)."""
        return self["displacement [mm]"]

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        for data in (self.point_data, self.cell_data):
            if name in data:
                return data[name]
        raise unknown("field", name, [*self.point_data, *self.cell_data])

    def to_pyvista(self) -> Any:
        """The fields as ``pyvista.UnstructuredGrid``. Needs pyvista."""
        import pyvista

        sizes = np.diff(self.offsets, prepend=np.uint32(0))
        starts = self.offsets - sizes
        cells = np.insert(self.connectivity.astype(np.int64), starts.astype(np.int64), sizes)
        grid = pyvista.UnstructuredGrid(cells, self.types, self.points)
        for name, values in self.point_data.items():
            grid.point_data[name] = values
        for name, values in self.cell_data.items():
            grid.cell_data[name] = values
        return grid

    def __repr__(self) -> str:
        names = ", ".join([*self.point_data, *self.cell_data])
        return f"<Fields at {self.time:g} s: {len(self.points)} points, {len(self.offsets)} cells; {names}>"


def listed(files: _reduced.Files | None) -> list[tuple[float, str]]:
    """Times [s] and files of the fields of a folder, as its list has them."""
    with reading("fields.pvd"):
        return files.field_times() if files else []


def fields_at(files: _reduced.Files | None, time: float | None) -> Fields:
    """Fields at a time of a folder; the last ones if the time is None."""
    entries = listed(files)
    if not entries or files is None:
        raise InputError("the result holds no fields\n  help: run the case with a folder and output.fields = true")
    if time is None:
        return _read(files, *entries[-1])
    for at, file in entries:
        if abs(at - time) <= 1e-6 * max(1.0, abs(time)):
            return _read(files, at, file)
    known = ", ".join(f"{at:g}" for at, _ in entries)
    raise InputError(f"the result holds no fields at {time:g} s\n  help: it has them at {known} s")


def _read(files: _reduced.Files, time: float, file: str) -> Fields:
    """The files of several ranks as one; points between ranks stand in each of them."""
    with reading(file):
        return _joined(time, files.fields(file))


def _joined(time: float, pieces: list[_reduced._Piece]) -> Fields:
    first_point = np.cumsum([0, *(len(piece["points"]) for piece in pieces)])
    first_end = np.cumsum([0, *(len(piece["connectivity"]) for piece in pieces)])

    def joined(arrays: list[npt.NDArray[Any]]) -> npt.NDArray[Any]:
        return arrays[0] if len(arrays) == 1 else np.concatenate(arrays)

    return Fields(
        time,
        joined([piece["points"] for piece in pieces]),
        joined([piece["connectivity"] + np.uint32(first_point[k]) for k, piece in enumerate(pieces)]),
        joined([piece["offsets"] + np.uint32(first_end[k]) for k, piece in enumerate(pieces)]),
        joined([piece["types"] for piece in pieces]),
        {name: joined([piece["point_data"][name] for piece in pieces]) for name in pieces[0]["point_data"]},
        {name: joined([piece["cell_data"][name] for piece in pieces]) for name in pieces[0]["cell_data"]},
    )
