"""What the columns of results mean. The extension module states it, from the schema that the writers use."""
from __future__ import annotations

import functools
import re
from typing import NamedTuple

from deadpoint import _reduced


class Column(NamedTuple):
    """A column of a table."""

    kind: str
    heading: str
    unit: str
    meaning: str


class Table(NamedTuple):
    """A table of a result folder."""

    meaning: str
    columns: dict[str, Column]


@functools.cache
def tables() -> dict[str, Table]:
    """All tables, by file name; a name in braces stands for what differs."""
    return {
        name: Table(meaning, {row[0]: Column(*row) for row in columns})
        for name, (meaning, columns) in _reduced.schema().items()
    }


def table(file: str) -> Table:
    """The table of a file, also of one like ``prediction_cold.csv``."""
    known = tables()
    if file in known:
        return known[file]
    for name, found in known.items():
        if "{" in name and name_in(name, file):
            return found
    return Table("", {})


@functools.cache
def _pattern(heading: str) -> re.Pattern[str]:
    before, brace, after = heading.partition("{")
    after = after.partition("}")[2]
    return re.compile(re.escape(before) + ("(.*)" if brace else "") + re.escape(after))


def name_in(heading: str, text: str) -> str:
    """What stands in a text in the place of the name in braces; the text itself if it does not fit."""
    found = _pattern(heading).fullmatch(text)
    return found.group(1) if found and found.groups() else text


@functools.cache
def dimensions() -> dict[str, str]:
    """Meaning of the dimensions of the chain, by name."""
    return dict(_reduced.dimensions())
