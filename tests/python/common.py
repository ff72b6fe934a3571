"""What the tests of the Python package share: files that make_files.sh made, and the command."""
import os
import pathlib
import subprocess
import sys

FILES = pathlib.Path(os.environ["DEADPOINT_FILES"])
SOURCE = pathlib.Path(os.environ["DEADPOINT_SOURCE_DIR"])
CASE = FILES / "case.toml"
ROM = FILES / "press.rom"


def command(*arguments):
    """The output of the command, which must succeed."""
    return subprocess.run([os.environ["DEADPOINT_COMMAND"], *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def python(text):
    """The output of a new interpreter, which must succeed."""
    return subprocess.run([sys.executable, "-W", "error", "-c", text], check=True, capture_output=True, text=True).stdout
