"""Requirement: a result folder opens with all series, units and meanings, equal to its files, without the field solver."""
import importlib
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import zlib
from pathlib import Path

import numpy as np

import deadpoint
import mutate_results
from common import CASE, FILES, command, python, resign


class Opened(unittest.TestCase):
    def setUp(self):
        self.result = deadpoint.open(FILES / "full")

    def test_series_are_those_of_the_file(self):
        lines = [line for line in (FILES / "full/history.csv").read_text().splitlines() if not line.startswith("#")]
        headings = lines[0].split(",")
        rows = np.array([[float(cell) for cell in line.split(",")] for line in lines[1:]])
        np.testing.assert_array_equal(self.result.gap.values, rows[:, headings.index("E_SW [um]")])
        np.testing.assert_array_equal(self.result.time, rows[:, 0])
        np.testing.assert_array_equal(self.result.probes["slide"], rows[:, headings.index("slide [degC]")])
        np.testing.assert_array_equal(self.result.joint_heat["crank_pin"], rows[:, headings.index("crank_pin heat [W]")])
        np.testing.assert_array_equal(self.result.joint_temperatures["guide"],
                                      rows[:, headings.index("guide temperature [degC]")])
        self.assertEqual(list(self.result.probes), ["bearing_front", "slide", "upright"])
        self.assertEqual(list(self.result.dimensions)[0], "E_SW")

    def test_series_carry_unit_and_meaning(self):
        self.assertEqual(self.result.gap.unit, "um")
        self.assertIn("gap between slide and table", self.result.gap.meaning)
        self.assertEqual(self.result.joint_heat["crank_pin"].unit, "W")
        self.assertEqual(self.result.joint_heat["crank_pin"].meaning, "friction heat of the joint")
        self.assertEqual({column.unit for column in self.result.tables["gaps"].of_kind("corner_gap")}, {"um"})
        for table in self.result.tables.values():
            self.assertTrue(table.meaning, table.file)
            for column in table.columns:
                self.assertTrue(column.meaning, f"{table.file}: {column.heading}")

    def test_figures_and_other_tables(self):
        summary = json.loads((FILES / "full/summary.json").read_text())
        self.assertEqual(self.result.summary, summary)
        self.assertAlmostEqual(self.result.gap.end, summary["drift_um"]["final_E_SW"], delta=1e-6)  # nine digits in the table
        parts = sum(series.values for series in self.result.contributions.values())
        self.assertAlmostEqual(parts[-1], self.result.gap.end, delta=1e-5)  # the file has nine digits
        # Between the steps the gap is cubic and its shares are linear.
        np.testing.assert_allclose(parts, self.result.gap.values, atol=5e-3 * abs(self.result.gap.end))
        self.assertEqual(len(self.result.corners), 4)
        self.assertIsNone(self.result.error)
        self.assertFalse(self.result.interrupted)

    def test_values_between_and_outside(self):
        probe = self.result.probes["slide"]
        middle = 0.5 * (probe.time[3] + probe.time[4])
        self.assertAlmostEqual(probe.at(middle), 0.5 * (probe.values[3] + probe.values[4]), delta=1e-12)
        self.assertEqual(probe.at(probe.time).shape, probe.time.shape)
        with self.assertRaisesRegex(deadpoint.InputError, "outside the run"):
            probe.at(1e9)
        np.testing.assert_array_equal(probe - probe.start, probe.values - probe.values[0])

    def test_unknown_names_suggest(self):
        with self.assertRaisesRegex(deadpoint.InputError, "did you mean 'slide'"):
            self.result.probes["slid"]
        with self.assertRaises(KeyError):
            self.result.tables["histroy"]

    def test_fields(self):
        np.testing.assert_array_equal(self.result.field_times, [600, 1200])
        fields = self.result.fields()
        self.assertEqual(fields.points.shape[1], 3)
        self.assertEqual(fields.temperature.shape, (len(fields.points),))
        self.assertEqual(fields.displacement.shape, fields.points.shape)
        self.assertEqual(fields["part"].shape, (len(fields.types),))
        self.assertEqual(int(fields.connectivity.max()), len(fields.points) - 1)
        self.assertEqual(int(fields.offsets[-1]), len(fields.connectivity))
        # The press is drawn in a box of 600 x 1300 x 520 mm, and its probes lie between coldest and warmest point.
        np.testing.assert_allclose(fields.points[:, 1].min(), -1.05, atol=1e-9)
        self.assertLess(fields.temperature.min(), self.result.probes["upright"].end)
        self.assertGreater(fields.temperature.max(), self.result.probes["bearing_front"].end)
        self.assertLess(self.result.fields(600).temperature.max(), fields.temperature.max())
        with self.assertRaisesRegex(deadpoint.InputError, "it has them at 600, 1200 s"):
            self.result.fields(5)

    def test_other_forms(self):
        try:
            importlib.import_module("pandas")
        except ImportError:
            self.skipTest("pandas is not here")
        frame = self.result.to_pandas()
        self.assertEqual(frame["E_SW [um]"].iloc[-1], self.result.gap.end)
        self.assertEqual(frame.index.name, "time [s]")
        self.assertIn("cause", self.result.to_pandas("causes"))
        try:
            importlib.import_module("xarray")
        except ImportError:
            return
        data = self.result.to_xarray()
        self.assertEqual(float(data["probe_temperature"].sel(probe_temperature_name="slide")[-1]),
                         self.result.probes["slide"].end)
        self.assertEqual(data["dimension"].attrs["units"], "um")
        self.assertEqual(data["heat_to_air"].dims, ("time",))

    def test_charts(self):
        try:
            import matplotlib.pyplot
        except ImportError:
            self.skipTest("matplotlib is not here")
        axes = self.result.plot.drift()
        np.testing.assert_array_equal(axes.get_lines()[0].get_ydata(), self.result.gap.values)
        self.assertEqual(axes.get_ylabel(), "change [um]")
        self.assertEqual(len(self.result.plot.temperatures().get_lines()), 3)
        lines = self.result.plot.contributions(most=2).get_lines()
        self.assertAlmostEqual(sum(line.get_ydata()[-1] for line in lines), self.result.gap.end, delta=1e-5)
        self.result.plot.heat()
        matplotlib.pyplot.close("all")

    def test_summary_for_notebooks(self):
        text = self.result._repr_html_()
        self.assertIn(f"{self.result.gap.end:+.2f} um", text)
        self.assertEqual(text.count("<svg"), 2)
        self.assertNotIn("<script", text)
        import xml.etree.ElementTree

        xml.etree.ElementTree.fromstring(f"<div>{text}</div>")


class Folders(unittest.TestCase):
    def test_what_is_no_result_is_refused_by_kind(self):
        with self.assertRaises(deadpoint.IoError) as caught:
            deadpoint.open(FILES / "none")
        self.assertIsInstance(caught.exception, OSError)
        self.assertIn("a folder that deadpoint has written", caught.exception.help)
        with self.assertRaisesRegex(deadpoint.InputError, "there is no deadpoint.json"):
            deadpoint.open(FILES)
        with tempfile.TemporaryDirectory() as folder:
            command("loads", "-q", CASE, "-o", Path(folder) / "loads")
            with self.assertRaisesRegex(deadpoint.InputError, "open_study"):
                deadpoint.open(Path(folder) / "loads")
            study = deadpoint.open_study(Path(folder) / "loads")
            self.assertIn("joints.csv", study.tables)
            self.assertIn("loads", study.figures)

    def changed_copy(self, name, change, signed=False):
        """A copy of a folder in which one file has other bytes."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        copy = Path(folder.name) / "copy"
        shutil.copytree(FILES / "full", copy)
        (copy / name).write_bytes(change((copy / name).read_bytes()))
        if signed:
            resign(copy, name)
        return copy

    def test_edited_cut_exchanged_and_unfinished_folders_are_refused_with_the_file(self):
        def digit(data):  # of the last row, same size
            return data[:-3] + (b"7" if data[-3:-2] != b"7" else b"8") + data[-2:]

        for name in ("history.csv", "gaps.csv", "summary.json", "case.toml"):
            for change in (digit, lambda data: data[: len(data) // 2], lambda data: (FILES / "reduced/causes.csv").read_bytes()):
                with self.assertRaisesRegex(deadpoint.InputError, f"{name}' was changed since deadpoint wrote it"):
                    deadpoint.open(self.changed_copy(name, change))
        copy = self.changed_copy("fields_0001.vtu", lambda data: data[:-20000])
        with self.assertRaisesRegex(deadpoint.InputError, "fields_0001.vtu' was changed"):
            deadpoint.open(copy)
        with self.assertRaisesRegex(deadpoint.InputError, "fields_0001.vtu' was changed"):
            deadpoint.open(self.changed_copy("fields_0001.vtu", digit)).fields(1200)
        copy = self.changed_copy("summary.json", lambda data: data)
        (copy / "gaps.csv").unlink()
        with self.assertRaisesRegex(deadpoint.IoError, "gaps.csv"):
            deadpoint.open(copy)
        (copy / "deadpoint.json").unlink()
        with self.assertRaisesRegex(deadpoint.InputError, "there is no deadpoint.json"):
            deadpoint.open(copy)
        (copy / "deadpoint.json").write_text('{"format": 99}')
        with self.assertRaisesRegex(deadpoint.InputError, "is of format 99"):
            deadpoint.open(copy)
        (copy / "deadpoint.json").write_text('{"written_by": "deadpoint", "format": 2, "unfinished": true}')
        with self.assertRaisesRegex(deadpoint.InputError, "is not finished"):
            deadpoint.open(copy)
        # A table that was added is none of the results.
        copy = self.changed_copy("summary.json", lambda data: data)
        shutil.copy(copy / "gaps.csv", copy / "more.csv")
        self.assertNotIn("more", deadpoint.open(copy).tables)

    def test_nothing_that_is_not_finite_is_taken_from_a_file(self):
        def last_cell(text):
            return lambda data: data.rstrip(b"\n").rpartition(b",")[0] + b"," + text + b"\n"

        for text in (b"nan", b"inf", b"-Infinity", b"1e999", b"1_0"):
            result = deadpoint.open(self.changed_copy("history.csv", last_cell(text), signed=True))
            with self.assertRaisesRegex(deadpoint.InputError, "history.csv' was changed"):
                [series for kind in result.tables["history"].columns for series in result.series(kind.kind).values()]
        for text in (b"NaN", b"Infinity", b"1e999"):
            copy = self.changed_copy("summary.json", lambda data: re.sub(rb'("interrupted": *)false', rb"\g<1>" + text, data), signed=True)
            with self.assertRaisesRegex(deadpoint.InputError, "summary.json' was changed"):
                deadpoint.open(copy).interrupted

    def test_pipes_devices_deep_json_and_bombs_are_refused_at_once(self):
        copy = self.changed_copy("summary.json", lambda data: b"[" * 1_000_000, signed=True)
        with self.assertRaisesRegex(deadpoint.InputError, "summary.json"):
            deadpoint.open(copy).name
        with tempfile.TemporaryDirectory() as folder:
            pipe = Path(folder) / "pipe"
            os.mkfifo(pipe)
            for file in (pipe, "/dev/zero", folder, "no\0name", "\udcff\ud800", "x" * 5000):
                for read in (deadpoint.load, deadpoint.open_rom, deadpoint.open, deadpoint.open_study):
                    start = time.perf_counter()
                    with self.assertRaises(deadpoint.Error, msg=f"{read.__name__} {file}"):
                        read(file)
                    self.assertLess(time.perf_counter() - start, 2)
            copy = self.changed_copy("summary.json", lambda data: data)
            for file in (pipe, Path("/dev/zero")):
                (copy / "gaps.csv").unlink()
                (copy / "gaps.csv").symlink_to(file)
                with self.assertRaisesRegex(deadpoint.Error, "gaps.csv"):
                    deadpoint.open(copy)

        def bomb(data):  # every block of a megabyte becomes one of sixteen
            head, mark, _ = data.partition(b"_")
            block = zlib.compress(bytes(1 << 24))
            counts = np.array([200, 1 << 24, 0, *[len(block)] * 200], "<u8").tobytes()
            return re.sub(rb'offset="\d+"', b'offset="0"', head) + mark + counts + 200 * block

        copy = self.changed_copy("fields_0001.vtu", bomb, signed=True)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        with self.assertRaisesRegex(deadpoint.InputError, "fields_0001.vtu"):
            deadpoint.open(copy).fields(1200)
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, 200_000)  # kB; the bomb has 3.4 GB

    def test_changed_folders_end_with_values_or_an_error_of_deadpoint(self):
        outcomes, broken, above = mutate_results.run(400)
        self.assertEqual(broken, [])
        self.assertLess(above, 200e6)
        self.assertGreater(outcomes["read"], 0)  # the changes reach what is behind the list
        self.assertGreater(outcomes["InputError"], 0)

    def test_no_chain_no_gap(self):
        copy = self.changed_copy("history.csv", lambda data: data.replace(b"dimension", b"to_air"), signed=True)
        with self.assertRaisesRegex(deadpoint.InputError, "no dimension chain"):
            deadpoint.open(copy).gap


class Command(unittest.TestCase):
    """The program that is called is the one that was installed, named or on the path, and no other."""

    def call(self, package, environment=None):
        code = ("import deadpoint\ntry:\n    deadpoint.compare('a', 'b')\n"
                "except deadpoint.Error as error:\n    print(type(error).__name__, error)")
        variables = {**os.environ, "PYTHONPATH": str(package.parent), "PATH": "", **(environment or {})}
        if environment is None:
            variables.pop("DEADPOINT_COMMAND")
        return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=variables, check=True).stdout

    def test_a_program_that_lies_near_is_not_run(self):
        with tempfile.TemporaryDirectory() as folder:
            for place, marked, runs in (("a/b/c/deadpoint", False, False), ("lib/python3/dist-packages/deadpoint", False, False),
                                        ("a/b/c/deadpoint", True, False), ("lib/python3/dist-packages/deadpoint", True, True)):
                root = Path(tempfile.mkdtemp(dir=folder))
                package = root / place
                shutil.copytree(Path(deadpoint.__file__).parent, package)
                planted = root / "bin/deadpoint"
                planted.parent.mkdir()
                planted.write_text("#!/bin/sh\necho planted >&2\nexit 2\n")
                planted.chmod(0o755)
                if marked:
                    (package / "installed").write_text("lib/python3/dist-packages/deadpoint\n")
                self.assertEqual("planted" in self.call(package), runs, place)

    def test_a_missing_or_broken_program_is_an_error_of_deadpoint(self):
        package = Path(deadpoint.__file__).parent
        self.assertIn("IoError the command 'deadpoint' is not here", self.call(package))
        for program in ("/no/such/program", "/etc", __file__):
            self.assertIn(f"IoError cannot start '{program}'", self.call(package, {"DEADPOINT_COMMAND": program}))
        with self.assertRaisesRegex(deadpoint.InputError, "null"):
            deadpoint.compare("a\0b", "c")


class Libraries(unittest.TestCase):
    def test_no_heavy_library_is_loaded(self):
        out = python(
            "import sys, deadpoint\n"
            f"deadpoint.open({str(FILES / 'full')!r}).fields()\n"
            f"deadpoint.open_rom({str(FILES / 'press.rom')!r}).run({str(CASE)!r}).error\n"
            "maps = open('/proc/self/maps').read().lower()\n"
            "assert 'libfmt' in maps\n"
            "print(*(word for word in ('deal', 'petsc', 'mpi', 'gmsh', 'mumps') if f'lib{word}' in maps),\n"
            "      *(name for name in ('pandas', 'matplotlib', 'xarray', 'tqdm') if name in sys.modules))")
        self.assertEqual(out.split(), [])


if __name__ == "__main__":
    unittest.main()
