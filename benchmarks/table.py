#!/usr/bin/env python3
"""Measures the table of docs/performance.md again: benchmarks/table.py [--program PROGRAM] [--only PATTERN] [--print]

Each row of the table whose command begins with `deadpoint` is run once, one after another, in a scratch folder. Its cells, wall time,
processor time and peak memory are written into the row, with the day; --print shows the rows instead. --only PATTERN, a regular
expression, chooses rows by their command. Other rows are left as they are. Memory is that of all processes of the command, shared
pages counted once, each 0.1 s. Let nothing else run on the machine.
"""
import argparse
import datetime
import json
import os
import re
import resource
import shlex
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "performance.md"


def memory(session):
    """Proportional set sizes of all processes of a session [byte]."""
    total = 0
    for process in Path("/proc").iterdir():
        try:
            if process.name.isdigit() and os.getsid(int(process.name)) == session:
                total += 1024 * int(re.search(r"^Pss: +(\d+)", (process / "smaps_rollup").read_text(), re.M)[1])
        except (OSError, TypeError):
            continue  # it has ended
    return total


def measured(program, command, scratch):
    """(cells, wall time [s], processor time [s], peak memory [byte]) of a command."""
    words = shlex.split(command)[1:]
    output = Path(scratch) / "out"
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    before, start, peak = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic(), 0
    with open(Path(scratch) / "log", "w+") as log:
        process = subprocess.Popen([program, *words, "-o", output], cwd=ROOT, env=environment, stdout=log, stderr=log,
                                   start_new_session=True)
        while process.poll() is None:
            peak = max(peak, memory(process.pid))
            time.sleep(0.1)
        wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
        if process.returncode:
            log.seek(0)
            raise SystemExit(f"error: {command} ended with {process.returncode}\n{log.read()[-2000:]}")
    summary = output / "summary.json"
    cells = json.loads(summary.read_text())["model"]["cells"] if summary.exists() else None
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return cells, wall, processor, peak


def row(program, line):
    """The row with its figures of today."""
    command = line.split("|")[1].strip()
    with tempfile.TemporaryDirectory() as scratch:
        cells, wall, processor, peak = measured(program, command.strip("`"), scratch)
    count = f"{cells:,}".replace(",", " ") if cells else ""
    digits = 1 if wall < 100 else 0
    return (f"| {command} | {count} | {wall:.{digits}f} s | {processor:.{digits}f} s | {peak / 1e9:.2f} GB "
            f"| {datetime.date.today()} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/app/deadpoint")
    parser.add_argument("--only", default="", help="regular expression: only rows with such a command")
    parser.add_argument("--print", action="store_true", help="print the rows, and leave the page as it is")
    options = parser.parse_args()
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        if line.startswith("| `deadpoint ") and re.search(options.only, line):
            new = row(options.program.resolve(), line)
            print(new, flush=True)
            if not options.print:
                PAGE.write_text(PAGE.read_text(encoding="utf-8").replace(line, new), encoding="utf-8")


if __name__ == "__main__":
    main()
