#!/usr/bin/env python3
"""Times of the Python package: benchmarks/python.py CASE ROM RESULTS, with build/<preset>/python in PYTHONPATH.

Prints the processor time of the import, of opening a result folder, what a reduced run costs more than in the library, and
how much memory 10 000 reduced runs leave behind.
"""
import gc
import os
import statistics
import subprocess
import sys
import time


def import_time():
    code = "import time; start = time.process_time(); import deadpoint; print(time.process_time() - start)"
    return min(float(subprocess.check_output([sys.executable, "-c", code])) for _ in range(5))


def opening_time(deadpoint, folder):
    start = time.process_time()
    result = deadpoint.open(folder)
    result.gap, result.probes, result.contributions, result.summary
    return time.process_time() - start


def extra_time(rom, press):
    extra = []
    for _ in range(200):
        start = time.perf_counter()
        result = rom.run(press, estimate=False, causes=False)
        extra.append(time.perf_counter() - start - result._run.seconds)
    return statistics.median(extra)


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def kept_memory(rom, press, count):
    def runs(times):
        for _ in range(times):
            rom.run(press, estimate=False, causes=False).gap
        gc.collect()

    runs(200)
    before = resident()
    runs(count)
    return resident() - before


def main():
    if len(sys.argv) != 4:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    case, model, results = sys.argv[1:]
    print(f"import: {import_time():.3f} s")
    import deadpoint

    print(f"opening {results}: {opening_time(deadpoint, results):.3f} s")
    rom, press = deadpoint.open_rom(model), deadpoint.load(case)
    print(f"a reduced run costs {1e3 * extra_time(rom, press):.3f} ms more than in the library")
    short = press.changed({"operation.0.duration": "2 min"})
    print(f"10 000 reduced runs leave {1e-6 * kept_memory(rom, short, 10000):.3f} MB behind")


main()
