"""What the tests of the Python package share: files that make_files.sh made, and the command."""
import json
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


def checksum(data):
    """FNV-1a of 64 bits, as deadpoint.json has it."""
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{value:016x}"


def resign(folder, *names):
    """Lists files of a folder as they are now, so that a reader meets what is in them. New names are added."""
    manifest = folder / "deadpoint.json"
    found = json.loads(manifest.read_text())
    for name in names:
        data = (folder / name).read_bytes()
        found["files"][name] = {"bytes": len(data), "checksum": checksum(data)}
    found["files"] = dict(sorted(found["files"].items()))
    found["checksum"] = checksum(json.dumps(found["files"], separators=(",", ":"), ensure_ascii=False).encode())
    manifest.write_text(json.dumps(found))
