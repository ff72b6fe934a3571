"""mutate_results.py COUNT [SEED]: opens changed result folders, whose lists are signed again so that what parses the files is reached.

Each change must end with values or with an error of deadpoint: no crash, no other exception, and no memory above four times the
folder and 200 MB. Prints the figures; the exit code is 1 where a change broke a reader.
"""
import collections
import pathlib
import random
import resource
import shutil
import sys
import tempfile
import time
import traceback
import zlib

import numpy as np

import deadpoint
from common import FILES, resign

TOKENS = (b"nan", b"inf", b"-1e999", b"1e308", b"NaN", b"Infinity", b"-", b",", b";", b'"', b"\n", b"\r", b"\0", b"[", b"]" * 50, b"{",
          b"}", b"[" * 5000, b"null", b"true", b"{}", b"0", b"99999999999999999999", b"# columns: time, time", b"time", b" [s]",
          b"\xff\xfe", "ü".encode(), b"../../../../dev/zero", b"<DataArray ", b'offset="0"', b"\xff" * 8, b"\0" * 8, b"1_0", b"0x10")


def changed(data, random_):
    """The bytes of a file after one to three changes."""
    data = bytearray(data)
    for _ in range(random_.choice((1, 1, 2, 3))):
        at = random_.randrange(len(data) + 1)
        kind = random_.randrange(8)
        if kind == 0 and data:
            data[at % len(data)] ^= 1 << random_.randrange(8)
        elif kind == 1:
            del data[at:]
        elif kind == 2:
            del data[at : at + random_.randrange(1, 200)]
        elif kind == 3:
            data[at:at] = data[at : at + random_.randrange(1, 2000)]
        elif kind == 4:
            data[at:at] = random_.choice(TOKENS)
        elif kind == 5:
            token = random_.choice(TOKENS)
            data[at : at + len(token)] = token
        elif kind == 6 and data:
            data[at % len(data)] = random_.randrange(256)
        else:  # a number or word of a text in the place of another
            words = bytes(data[:20000]).split()
            if words:
                old, new = random_.choice(words), random_.choice(words)
                data = bytearray(bytes(data).replace(old, new, 1))
    return bytes(data)


def packed_again(data, random_):
    """A field file in which one block unpacks to other bytes, with a sound checksum of zlib."""
    at = data.find(b"\x78", data.find(b"_") + 1 + random_.randrange(max(len(data) // 2, 1)))
    try:
        reader = zlib.decompressobj()
        block = bytearray(reader.decompress(data[at:]))
    except zlib.error:
        return changed(data, random_)
    if block:
        place = random_.randrange(len(block))
        block[place : place + 8] = random_.randbytes(8)
    packed = zlib.compress(bytes(block))
    return data[:at] + packed + reader.unused_data


def use(result, fields):
    """Everything that a result offers."""
    repr(result)
    result._repr_html_()
    for named in (result.probes, result.joint_temperatures, result.joint_heat, result.dimensions, result.contributions, result.corners,
                  result.clearances):
        for series in named.values():
            assert np.isfinite(series.time).all() and not np.isinf(series.values).any(), series.name
            series.at(series.time[-1]), series.largest, repr(series)
    for table in result.tables.values():
        repr(table), len(table)
    assert result.name is not None and result.case_hash is not None
    list(result.warnings), result.interrupted, result.error, result.outside, result.field_times
    if fields:
        found = result.fields()
        assert np.isfinite(found.points).all() and np.isfinite(found.temperature).all() and np.isfinite(found.displacement).all()
        found.cells, repr(found)


class Mutations:
    """Changes of one folder, one after the other."""

    def __init__(self, folder, seed):
        self.whole, self.random = folder, random.Random(seed)
        memory = pathlib.Path("/dev/shm")
        self.scratch = tempfile.TemporaryDirectory(dir=memory if memory.is_dir() else None)
        self.folder = pathlib.Path(self.scratch.name) / "r"
        shutil.copytree(folder, self.folder)
        self.manifest = (folder / "deadpoint.json").read_bytes()
        self.names = [name for name in sorted(path.name for path in folder.iterdir() if path.is_file())
                      if name.endswith((".csv", "summary.json", ".vtu", ".pvd", "deadpoint.json"))]
        self.size = sum(path.stat().st_size for path in folder.iterdir())
        self.outcomes = collections.Counter()
        self.broken = []

    def one(self):
        name = self.random.choice(self.names)
        data = (self.whole / name).read_bytes()
        is_field = name.endswith((".vtu", ".pvd"))
        change = packed_again if name.endswith(".vtu") and self.random.random() < 0.5 else changed
        new = change(data, self.random)
        (self.folder / name).write_bytes(new)
        if name != "deadpoint.json":
            resign(self.folder, name)
        try:
            use(deadpoint.open(self.folder), is_field)
            self.outcomes["read"] += 1
        except deadpoint.Error as error:
            self.outcomes[type(error).__name__] += 1
        except Exception:
            self.outcomes["broken"] += 1
            self.broken.append((name, traceback.format_exc()))
        (self.folder / name).write_bytes(data)
        (self.folder / "deadpoint.json").write_bytes(self.manifest)


def run(count, seed=1, folder=FILES / "full"):
    """Outcomes by kind, what broke, and the memory that was taken above four times the folder [byte]."""
    mutations = Mutations(folder, seed)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(count):
        mutations.one()
    grown = 1024 * (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
    return mutations.outcomes, mutations.broken, grown - 4 * mutations.size


def main():
    start = time.perf_counter()
    outcomes, broken, above = run(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    for name, text in broken[:5]:
        print(name, text, sep="\n")
    print(f"{sum(outcomes.values())} changes in {time.perf_counter() - start:.0f} s: {dict(outcomes)}; memory above four times the "
          f"folder: {max(above, 0) / 1e6:.0f} MB")
    sys.exit(1 if broken or above > 200e6 else 0)


if __name__ == "__main__":
    main()
