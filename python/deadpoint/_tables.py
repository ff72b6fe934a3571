"""Tables of results: from the files of a folder, or from a run in memory."""
from __future__ import annotations

import csv
import io
import json
import pathlib
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, Union

import numpy as np

from deadpoint import _schema
from deadpoint._errors import InputError, IoError, unknown
from deadpoint._series import Array

if TYPE_CHECKING:
    import pandas

Values = Union[Array, "list[str]"]


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


def _numbers(cells: list[str], comma: bool) -> Values:
    try:
        return np.array([float(cell.replace(",", ".") if comma else cell) if cell else np.nan for cell in cells])
    except ValueError:
        return cells


def _heading(text: str) -> tuple[str, str]:
    if text.endswith("]") and " [" in text:
        heading, _, unit = text.rpartition(" [")
        return heading, unit[:-1]
    return text, ""


def _head_beside(path: pathlib.Path) -> tuple[list[str], bool]:
    """Kinds of the columns of a table that lost its comment lines (``--csv``), and whether it has decimal commas."""
    beside = path.parent / "tables.json"
    try:
        heads = json.loads(beside.read_text(encoding="utf-8"))
        for line in heads["heads"].get(path.name, []):
            if line.startswith("columns: "):
                return line[len("columns: ") :].split(", "), heads["style"] == "comma"
    except FileNotFoundError:
        pass
    except (ValueError, KeyError, AttributeError) as error:
        raise InputError(f"'{beside}' was changed or cut short\n  help: compute it again") from error
    return [], False


def read_table(path: pathlib.Path) -> Table:
    """Reads a table that deadpoint wrote: comments, the line with the kinds, the heading and the rows."""
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise IoError(f"cannot read '{path}': {error.strerror}") from error
    kinds: list[str] = []
    rest = io.StringIO(text)
    position = 0
    for line in rest:
        if not line.startswith("#"):
            break
        if line.startswith("# columns: "):
            kinds = line[len("# columns: ") :].strip().split(", ")
        position += len(line)
    comma = False
    if not kinds:
        kinds, comma = _head_beside(path)
    if not kinds:
        raise InputError(f"'{path}' is not a table that deadpoint wrote\n  help: it lacks the line '# columns: ...'")
    rows = list(csv.reader(io.StringIO(text[position:]), delimiter=";" if comma else ","))
    if not rows or any(len(row) != len(kinds) for row in rows):
        raise InputError(f"'{path}' was changed or cut short\n  help: compute it again")
    columns = []
    for index, (kind, title) in enumerate(zip(kinds, rows[0])):
        heading, unit = _heading(title)
        columns.append(column_of(path.name, kind, heading, unit, _numbers([row[index] for row in rows[1:]], comma)))
    return Table(path.name, columns)


class Tables(Mapping[str, Table]):
    """Tables by name, with or without ``.csv``. A table of a folder is read when it is first used."""

    def __init__(self, folder: pathlib.Path | None, ready: dict[str, Table] | None = None) -> None:
        self._folder = folder
        self._ready: dict[str, Table] = dict(ready or {})
        files = sorted(path.name for path in folder.glob("*.csv")) if folder else []
        self._names = list(dict.fromkeys([*self._ready, *files]))

    def __getitem__(self, name: str) -> Table:
        file = name if name.endswith(".csv") else f"{name}.csv"
        if file not in self._names:
            raise unknown("table", name, self._names)
        if file not in self._ready:
            assert self._folder is not None
            self._ready[file] = read_table(self._folder / file)
        return self._ready[file]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __contains__(self, name: Any) -> bool:
        return name in self._names or f"{name}.csv" in self._names

    def __repr__(self) -> str:
        return f"<Tables: {', '.join(self._names)}>"
