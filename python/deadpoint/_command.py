"""Calls of the command ``deadpoint``, for the verbs that write folders."""
from __future__ import annotations

import contextlib
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Sequence
from typing import IO, TYPE_CHECKING, Any

from deadpoint._errors import InputError, IoError, error_of, reading

if TYPE_CHECKING:
    from deadpoint._press import Press

STOPPED = 130
PATIENCE = 0.7  # [s] for a command to end after Ctrl-C before it goes on alone


def _installed() -> str | None:
    """The command in the prefix of the package; None where the package was not installed together with it."""
    package = pathlib.Path(__file__).resolve().parent
    try:
        place = (package / "installed").read_text(encoding="utf-8").strip()
    except OSError:
        return None
    if not package.as_posix().endswith(f"/{place}"):
        return None
    program = package.parents[place.count("/")] / "bin" / "deadpoint"
    return str(program) if program.is_file() else None


def command() -> str:
    """The command: that of DEADPOINT_COMMAND, of the prefix into which the package was installed, or of the path."""
    found = os.environ.get("DEADPOINT_COMMAND") or _installed() or shutil.which("deadpoint")
    if found is None:
        raise IoError("the command 'deadpoint' is not here\n  help: install the package deadpoint, or name the program in the "
                      "environment variable DEADPOINT_COMMAND")
    return found


def case_arguments(press: Press) -> list[Any]:
    """A case with its changes, as arguments."""
    changes = [argument for key, value in press.settings.items() for argument in ("--set", f"{key}={value}")]
    return [press.file, *changes, *(["--allow-outside"] if press.allow_outside else [])]


def call(verb: str, arguments: Sequence[Any], progress: bool) -> str:
    """Calls the command and returns its text. Ctrl-C stops it cleanly.

    :raises deadpoint.Error: of the kind of its exit code, with its text
    """
    line = [command(), verb, *map(str, arguments), *([] if progress else ["--quiet"])]
    with reading(f"output of {line[0]}"), tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as out:
        code, errors = _watched(line, out, progress)
        out.seek(0)
        text = out.read()
    if code == STOPPED:
        raise KeyboardInterrupt
    if code < 0:
        raise error_of(code, f"{errors}\nthe command was ended by signal {-code}".strip())
    if code != 0:
        raise error_of(code, errors.rpartition("error: ")[2] if errors.count("error: ") == 1 else errors)
    return text


def _started(line: list[str], out: IO[str]) -> subprocess.Popen[str]:
    try:
        return subprocess.Popen(line, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.PIPE, encoding="utf-8",
                                errors="replace", start_new_session=True)
    except OSError as error:
        raise IoError(f"cannot start '{line[0]}': {error.strerror}\n  help: name the program deadpoint in the environment "
                      "variable DEADPOINT_COMMAND, or install the package deadpoint") from error
    except ValueError as error:
        raise InputError(f"an argument of 'deadpoint {line[1]}' cannot be passed on: {error}") from error


def _watched(line: list[str], out: IO[str], progress: bool) -> tuple[int, str]:
    """Exit code of a command and the text on its standard error, which is shown if wanted."""
    errors: list[str] = []
    child = _started(line, out)
    assert child.stderr is not None
    try:
        for text in child.stderr:
            errors.append(text)
            if progress:
                with contextlib.suppress(OSError, ValueError):
                    sys.stderr.write(text)
        code = child.wait()
    except KeyboardInterrupt:
        _stop(child)
        raise
    child.stderr.close()
    return code, "".join(errors).rstrip()


def _stop(child: subprocess.Popen[str]) -> None:
    """Asks a command to stop. One that needs long for its step ends after it, without anybody waiting, and keeps its results."""
    child.send_signal(signal.SIGINT)
    last = threading.Thread(target=child.communicate, daemon=True)
    last.start()
    last.join(PATIENCE)
