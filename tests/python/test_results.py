"""Requirement: a result folder opens with all series, units and meanings, equal to its files, without the field solver."""
import importlib
import json
import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np

import deadpoint
from common import CASE, FILES, command, python


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
        self.assertIn("deadpoint run", caught.exception.help)
        with self.assertRaisesRegex(deadpoint.InputError, "deadpoint.json is missing"):
            deadpoint.open(FILES)
        with tempfile.TemporaryDirectory() as folder:
            command("loads", "-q", CASE, "-o", Path(folder) / "loads")
            with self.assertRaisesRegex(deadpoint.InputError, "open_study"):
                deadpoint.open(Path(folder) / "loads")
            study = deadpoint.open_study(Path(folder) / "loads")
            self.assertIn("joints.csv", study.tables)
            self.assertIn("loads", study.figures)

    def test_broken_files_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / "copy"
            shutil.copytree(FILES / "full", copy)
            text = (copy / "history.csv").read_text()
            (copy / "history.csv").write_text(text[: len(text) // 2].rpartition(",")[0])
            with self.assertRaisesRegex(deadpoint.InputError, "cut short"):
                deadpoint.open(copy).gap
            field = next(copy.glob("fields_0001.vtu"))
            field.write_bytes(field.read_bytes()[:-20000])
            with self.assertRaisesRegex(deadpoint.InputError, "cut short"):
                deadpoint.open(copy).fields()
            (copy / "deadpoint.json").write_text('{"format": 99}')
            with self.assertRaisesRegex(deadpoint.InputError, "another format"):
                deadpoint.open(copy)

    def test_no_chain_no_gap(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / "copy"
            shutil.copytree(FILES / "full", copy)
            lines = (copy / "history.csv").read_text().replace("dimension", "to_air").splitlines(keepends=True)
            (copy / "history.csv").write_text("".join(lines))
            with self.assertRaisesRegex(deadpoint.InputError, "no dimension chain"):
                deadpoint.open(copy).gap


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
