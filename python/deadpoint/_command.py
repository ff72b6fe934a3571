"""Calls of the command ``deadpoint``, for the verbs that write folders."""
from __future__ import annotations

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from typing import IO, TYPE_CHECKING, Any

from deadpoint._errors import IoError, error_of

if TYPE_CHECKING:
    from deadpoint._press import Press

STOPPED = 130


def command() -> str:
    """The command: that of DEADPOINT_COMMAND, of the prefix into which the package was installed, or of the path."""
    wanted = os.environ.get("DEADPOINT_COMMAND")
    if wanted:
        return wanted
    installed = pathlib.Path(__file__).resolve().parents[4] / "bin" / "deadpoint"
    found = str(installed) if installed.exists() else shutil.which("deadpoint")
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
    with tempfile.TemporaryFile("w+") as out:
        code, errors = _watched(line, out, progress)
        out.seek(0)
        text = out.read()
    if code == STOPPED:
        raise KeyboardInterrupt
    if code != 0:
        raise error_of(code, errors.rpartition("error: ")[2] if errors.count("error: ") == 1 else errors)
    return text


def _watched(line: list[str], out: IO[str], progress: bool) -> tuple[int, str]:
    """Exit code of a command and the text on its standard error, which is shown if wanted."""
    errors: list[str] = []
    with subprocess.Popen(line, stdout=out, stderr=subprocess.PIPE, text=True, start_new_session=True) as child:
        assert child.stderr is not None
        try:
            for text in child.stderr:
                errors.append(text)
                if progress:
                    sys.stderr.write(text)
            return child.wait(), "".join(errors).rstrip()
        except KeyboardInterrupt:
            child.send_signal(signal.SIGINT)
            child.stderr.read()
            raise
