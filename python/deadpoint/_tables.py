"""Tables of results: from the files of a folder, or from a run in memory."""
from __future__ import annotations

import array
import csv
import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, Union

import numpy as np

from deadpoint import _schema
from deadpoint._errors import IoError, reading, unknown
from deadpoint._series import Array

if TYPE_CHECKING:
    import pandas

    from deadpoint import _reduced

Values = Union[Array, "list[str]"]


def needed(files: _reduced.Files, name: str) -> bytes:
    """The bytes of a file that must be there, as they were written. For deadpoint itself."""
    data = files.read(name)
    if data is None:
        raise IoError(f"there is no '{name}' among these results\n  help: compute them again")
    return data


class TableColumn(NamedTuple):
    """A column of a table, with what the schema says of it."""

    kind: str
    """What it holds, as in docs/result-files.md: ``probe_temperature``. Empty where that is not known."""
    heading: str
    """As in the file, without the unit: ``crank_pin heat``."""
    name: str
    """What stands in the heading for the name in the case: ``crank_pin``."""
    unit: str
    """Unit of the values; empty: none."""
    meaning: str
    """One sentence that says what it holds."""
    values: Values
    """Numbers, shape (rows,), not a number in empty cells; or texts."""


class Table:
    """A table: ``table["E_SW"]`` is the column of that heading."""

    def __init__(self, file: str, columns: list[TableColumn]) -> None:
        self.file = file
        """Name of the file: ``history.csv``."""
        self.meaning = _schema.table(file).meaning
        """One sentence about the table."""
        self.columns = columns
        """All columns, in the order of the file."""

    def __getitem__(self, heading: str) -> Any:
        for column in self.columns:
            if column.heading == heading:
                return column.values
        raise unknown(f"column in {self.file}", heading, [column.heading for column in self.columns])

    def of_kind(self, kind: str) -> list[TableColumn]:
        """All columns of a kind."""
        return [column for column in self.columns if column.kind == kind]

    def __len__(self) -> int:
        return len(self.columns[0].values) if self.columns else 0

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a data frame; headings carry their unit as in the file: ``E_SW [um]``."""
        import pandas

        return pandas.DataFrame(
            {f"{c.heading} [{c.unit}]" if c.unit else c.heading: c.values for c in self.columns}
        )

    def __repr__(self) -> str:
        headings = ", ".join(column.heading for column in self.columns[:6])
        return f"<Table {self.file}: {len(self)} rows of {len(self.columns)} columns ({headings}, ...)>"


def column_of(file: str, kind: str, heading: str, unit: str, values: Values) -> TableColumn:
    """A column with the meaning that the schema states."""
    known = _schema.table(file).columns.get(kind)
    if known is None:
        return TableColumn(kind, heading, heading, unit, "", values)
    return TableColumn(kind, heading, _schema.name_in(known.heading, heading), unit, known.meaning, values)


def _heading(text: str) -> tuple[str, str]:
    if text.endswith("]") and " [" in text:
        heading, _, unit = text.rpartition(" [")
        return heading, unit[:-1]
    return text, ""


_PLAIN = frozenset("0123456789+-.eE")


def _number(cell: str) -> float:
    """:raises ValueError: if a cell is neither empty nor a finite number"""
    if not cell:
        return math.nan
    value = float(cell)
    if not math.isfinite(value):
        raise ValueError(f"'{cell}' is not a finite number")
    if not _PLAIN.issuperset(cell):
        raise ValueError(f"'{cell}' is no number")  # Python also reads 1_0
    return value


def _columns(text: str, count: int) -> list[Values]:
    """Columns below the heading. Rows are not kept: a cell takes 8 bytes as a number, and many times that as text."""
    numbers: list[array.array[float] | None] = [array.array("d") for _ in range(count)]
    for row in _rows(text):
        if len(row) != count:
            raise ValueError(f"a row has {len(row)} cells below {count} headings")
        for index, cell in enumerate(row):
            column = numbers[index]
            if column is None:
                continue
            try:
                column.append(_number(cell))
            except ValueError:
                numbers[index] = None
    texts = [index for index, column in enumerate(numbers) if column is None]
    kept: dict[int, list[str]] = {index: [] for index in texts}
    for row in _rows(text) if texts else ():
        for index in texts:
            kept[index].append(row[index])
    return [kept[index] if column is None else np.array(column) for index, column in enumerate(numbers)]


def _rows(text: str) -> Iterator[list[str]]:
    """Rows of a table behind its heading."""
    rows = csv.reader(_lines(text))
    next(rows)
    yield from rows


def _lines(text: str) -> Iterator[str]:
    start = 0
    while start < len(text):
        end = text.find("\n", start) + 1 or len(text)
        yield text[start:end]
        start = end


def read_table(file: str, data: bytes) -> Table:
    """A table that deadpoint wrote: comments, the line with the kinds, the heading and the rows."""
    text = data.decode("utf-8")
    kinds: list[str] = []
    position = 0
    for line in _lines(text):
        if not line.startswith("#"):
            break
        if line.startswith("# columns: "):
            kinds = line[len("# columns: ") :].strip().split(", ")
        position += len(line)
    if not kinds:
        raise ValueError("it lacks the line '# columns: ...'")
    text = text[position:]
    titles: list[str] = next(csv.reader(_lines(text)), [])
    if len(titles) != len(kinds):
        raise ValueError(f"it has {len(titles)} headings of {len(kinds)} kinds")
    columns = []
    for kind, title, values in zip(kinds, titles, _columns(text, len(kinds))):
        heading, unit = _heading(title)
        columns.append(column_of(file, kind, heading, unit, values))
    return Table(file, columns)


class Tables(Mapping[str, Table]):
    """Tables by name, with or without ``.csv``. A table of a folder is read when it is first used."""

    def __init__(self, files: _reduced.Files | None, ready: dict[str, Table] | None = None) -> None:
        self._files = files
        self._ready: dict[str, Table] = dict(ready or {})
        listed = [name for name in files.names if name.endswith(".csv") and "/" not in name] if files else []
        self._names = list(dict.fromkeys([*self._ready, *listed]))

    def __getitem__(self, name: str) -> Table:
        file = name if name.endswith(".csv") else f"{name}.csv"
        if file not in self._names:
            raise unknown("table", name, self._names)
        if file not in self._ready:
            assert self._files is not None
            with reading(file):
                self._ready[file] = read_table(file, needed(self._files, file))
        return self._ready[file]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __contains__(self, name: Any) -> bool:
        return name in self._names or f"{name}.csv" in self._names

    def __repr__(self) -> str:
        return f"<Tables: {', '.join(self._names)}>"
