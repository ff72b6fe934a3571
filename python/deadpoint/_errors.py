"""Errors of deadpoint, and what a check finds in a case."""
from __future__ import annotations

import contextlib
import os
import pathlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable


@dataclass(frozen=True)
class Finding:
    """One mistake or warning of a case."""

    path: str
    """Key of the case: ``joints.crank_pin.diameter``. Empty where no key is meant."""
    file: str
    """File in which it stands. Empty: nowhere."""
    line: int
    """Line, from 1. 0: the file as a whole."""
    column: int
    """Column, from 1. 0: the line as a whole."""
    severity: str
    """``error`` or ``warning``."""
    code: str
    """Short name of the kind of mistake: ``unit-mismatch``."""
    message: str
    """The mistake, in one sentence."""
    help: str
    """The remedy. May be empty."""

    @property
    def place(self) -> str:
        """``file:line:column``, as far as it is known."""
        numbers = [str(number) for number in (self.line, self.column) if number]
        return ":".join([self.file, *numbers]) if self.file else ""

    def __str__(self) -> str:
        head = f"{self.place}: " if self.place else ""
        path = f"{self.path}: " if self.path else ""
        remedy = f"\n  help: {self.help}" if self.help else ""
        return f"{head}{self.severity}: {path}{self.message}{remedy}"


class Error(Exception):
    """Base of all errors of deadpoint. ``str(error)`` states the error, its place and its remedy.

    Besides these and :class:`deadpoint.Interrupted` only Python's own errors of programming leave the package: TypeError for
    an argument of a wrong type, and ImportError where an optional package is not installed.
    """

    def __init__(self, text: str, findings: Iterable[Finding] = ()) -> None:
        super().__init__(text)
        self.findings: list[Finding] = list(findings)
        """All mistakes of a case, where the error is one of a case."""

    def _first(self) -> Finding | None:
        return next((finding for finding in self.findings if finding.severity == "error"), None)

    @property
    def path(self) -> str:
        """Key of the case at fault (the first one); empty if none is meant."""
        first = self._first()
        return first.path if first else ""

    @property
    def place(self) -> str:
        """``file:line:column`` of the first mistake; empty if it is in no file."""
        first = self._first()
        return first.place if first else ""

    @property
    def help(self) -> str:
        """The remedy; may be empty."""
        first = self._first()
        return first.help if first else str(self).partition("\n  help: ")[2]


class InputError(Error, ValueError):
    """The input is wrong: case, file of a study, geometry, argument. Exit code 2 of the command."""


class NameUnknown(InputError, KeyError):
    """A result, a table or a case has nothing of this name."""

    def __str__(self) -> str:
        return str(self.args[0])


class DomainError(Error, ArithmeticError):
    """A value left the range in which a law is valid. Exit code 3 of the command."""


class ConvergenceError(Error, ArithmeticError):
    """A solver did not reach its tolerance. Exit code 4 of the command."""


class IoError(Error, OSError):
    """A file or folder could not be read or written. Exit code 5 of the command."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C stopped a run. ``result`` holds everything up to the last finished step."""

    def __init__(self, result: Any) -> None:
        super().__init__("the run was stopped; the attribute 'result' of this exception holds what it computed")
        self.result = result


_CLASSES: dict[int, type[Error]] = {2: InputError, 3: DomainError, 4: ConvergenceError, 5: IoError}


def error_of(code: int, text: str, findings: Iterable[Finding] = ()) -> Error:
    """The error of an exit code of the command. For deadpoint itself."""
    return _CLASSES.get(code, Error)(text, findings)


@contextlib.contextmanager
def reading(what: object) -> Iterator[None]:
    """Whatever goes wrong while a file is read and taken apart becomes an error of deadpoint. For deadpoint itself."""
    try:
        yield
    except Error:
        raise
    except OSError as error:
        raise IoError(f"cannot read '{what}': {error.strerror or error}\n  help: check that it is there and that you may "
                      "read it") from error
    except MemoryError as error:
        raise Error(f"'{what}' does not fit into the memory") from error
    except Exception as error:
        raise InputError(f"'{what}' was changed or cut short: {type(error).__name__} {error}\n  help: compute it again") from error


@contextlib.contextmanager
def writing(what: object) -> Iterator[None]:
    """The same for a file or folder that is written. For deadpoint itself."""
    try:
        yield
    except Error:
        raise
    except OSError as error:
        raise IoError(f"cannot write '{what}': {error.strerror or error}\n  help: check the folder and its permissions") from error


def path_of(value: str | os.PathLike[str]) -> pathlib.Path:
    """A path that a system call can take. For deadpoint itself.

    :raises TypeError: if it is no text and no path
    """
    path = pathlib.Path(value)
    try:
        if b"\0" not in os.fsencode(path):
            return path
    except UnicodeError:
        pass
    raise InputError(f"{str(path)!r} is no path: it has characters that no file name may have")


def unknown(kind: str, name: object, known: Iterable[str]) -> NameUnknown:
    """The error for an unknown name, with the most similar known ones. For deadpoint itself."""
    import difflib

    names = list(known)
    close = difflib.get_close_matches(str(name), names, 1)
    if close:
        remedy = f"did you mean '{close[0]}'?"
    elif names:
        remedy = "there are " + ", ".join(f"'{one}'" for one in names[:20])
    else:
        remedy = "there are none"
    return NameUnknown(f"there is no {kind} '{name}'\n  help: {remedy}")
