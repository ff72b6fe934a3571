"""Fields of a run on its mesh, from the VTU files of a result folder."""
from __future__ import annotations

import pathlib
import zlib
from typing import Any
from xml.etree import ElementTree

import numpy as np
import numpy.typing as npt

from deadpoint._errors import InputError, IoError, unknown

_TYPES = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt32": "<u4", "UInt8": "<u1"}
_MARK = b'<AppendedData encoding="raw">\n_'


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


def listed(folder: pathlib.Path | None) -> list[tuple[float, pathlib.Path]]:
    """Times [s] and files of the fields of a folder, ascending."""
    if folder is None or not (folder / "fields.pvd").exists():
        return []
    root = _xml((folder / "fields.pvd").read_bytes(), folder / "fields.pvd")
    return [(float(entry.attrib["timestep"]), folder / entry.attrib["file"]) for entry in root.iter("DataSet")]


def fields_at(folder: pathlib.Path | None, time: float | None) -> Fields:
    """Fields at a time of a folder; the last ones if the time is None."""
    entries = listed(folder)
    if not entries:
        raise InputError("the result holds no fields\n  help: run the case with a folder and output.fields = true")
    if time is None:
        return _read(*entries[-1])
    for at, file in entries:
        if abs(at - time) <= 1e-6 * max(1.0, abs(time)):
            return _read(at, file)
    known = ", ".join(f"{at:g}" for at, _ in entries)
    raise InputError(f"the result holds no fields at {time:g} s\n  help: it has them at {known} s")


def _xml(text: bytes, file: pathlib.Path) -> ElementTree.Element:
    try:
        return ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        raise InputError(f"'{file}' was changed or cut short: {error}\n  help: compute it again") from error


def _array(data: bytes, offset: int, kind: str, components: int) -> npt.NDArray[Any]:
    """One array of the appended section: VTK's list of compressed blocks."""
    blocks, _, _ = np.frombuffer(data, "<u8", 3, offset)
    sizes = np.frombuffer(data, "<u8", int(blocks), offset + 24)
    at = offset + 24 + 8 * int(blocks)
    pieces = []
    for size in sizes.tolist():
        pieces.append(zlib.decompress(data[at : at + size]))
        at += size
    values = np.frombuffer(b"".join(pieces), _TYPES[kind])
    return values.reshape(-1, components) if components > 1 else values


def _read(time: float, file: pathlib.Path) -> Fields:
    try:
        text = file.read_bytes()
    except OSError as error:
        raise IoError(f"cannot read '{file}': {error.strerror}") from error
    if file.suffix == ".pvtu":
        return _read_pieces(time, file, text)
    head, mark, data = text.partition(_MARK)
    if not mark:
        raise InputError(f"'{file}' is not a field file of deadpoint\n  help: compute it again")
    root = _xml(head + b"</VTKFile>", file)
    try:
        found = {section: _section(root, section, data) for section in ("Points", "Cells", "PointData", "CellData")}
        cells = found["Cells"]
        return Fields(time, found["Points"]["Points"], cells["connectivity"], cells["offsets"], cells["types"],
                      found["PointData"], found["CellData"])
    except (zlib.error, ValueError, KeyError) as error:
        raise InputError(f"'{file}' was changed or cut short\n  help: compute it again") from error


def _section(root: ElementTree.Element, name: str, data: bytes) -> dict[str, npt.NDArray[Any]]:
    section = root.find(f".//{name}")
    if section is None:
        return {}
    return {
        entry.attrib["Name"]: _array(data, int(entry.attrib["offset"]), entry.attrib["type"],
                                     int(entry.attrib["NumberOfComponents"]))
        for entry in section.iter("DataArray")
    }


def _read_pieces(time: float, file: pathlib.Path, text: bytes) -> Fields:
    """The files of several ranks as one; points between ranks stand in each of them."""
    pieces = [_read(time, file.parent / entry.attrib["Source"]) for entry in _xml(text, file).iter("Piece")]
    first_point = np.cumsum([0, *(len(piece.points) for piece in pieces)])
    first_end = np.cumsum([0, *(len(piece.connectivity) for piece in pieces)])

    def joined(arrays: list[npt.NDArray[Any]]) -> npt.NDArray[Any]:
        return np.concatenate(arrays)

    return Fields(
        time,
        joined([piece.points for piece in pieces]),
        joined([piece.connectivity + np.uint32(first_point[k]) for k, piece in enumerate(pieces)]),
        joined([piece.offsets + np.uint32(first_end[k]) for k, piece in enumerate(pieces)]),
        joined([piece.types for piece in pieces]),
        {name: joined([piece.point_data[name] for piece in pieces]) for name in pieces[0].point_data},
        {name: joined([piece.cell_data[name] for piece in pieces]) for name in pieces[0].cell_data},
    )
