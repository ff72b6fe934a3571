"""Requirement: a reduced press runs in Python as by the command, to the last bit, its estimate to rounding; errors carry their place."""
import gc
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings
from pathlib import Path

import numpy as np

import deadpoint
from common import CASE, FILES, ROM, command

FIXED = ["case.toml", "history.csv", "contributions.csv", "gaps.csv", "causes.csv",
         "drift.svg", "joints.csv"]


class Cases(unittest.TestCase):
    def test_keys_are_read_and_set_as_on_the_command_line(self):
        press = deadpoint.load(CASE)
        self.assertEqual(press["operation.0.speed"], "60 rpm")
        self.assertEqual(press["joints.crank_bearing.interfaces.back.diameter"], "80 mm")
        press["operation.0.speed"] = "90 rpm"
        press["surfaces.air_frame.film.emissivity"] = 0.5
        press["output.fields"] = False
        self.assertEqual(press["operation.0.speed"], "90 rpm")
        self.assertEqual(press["surfaces.air_frame.film.emissivity"], 0.5)
        self.assertIs(press["output.fields"], False)
        press["output.field_times"] = ["10 min", "20 min"]
        self.assertEqual(len(press["output.field_times"]), 2)
        self.assertEqual(press.settings["operation.0.speed"], "90 rpm")

    def test_a_case_is_that_of_the_command_bit_by_bit(self):
        press = deadpoint.load(CASE)
        summary = json.loads((FILES / "reduced/summary.json").read_text())
        self.assertEqual(press.hash, summary["case"]["hash"])
        with tempfile.TemporaryDirectory() as folder:
            press.save(Path(folder) / "again.toml")
            self.assertEqual(deadpoint.load(Path(folder) / "again.toml").hash, press.hash)
            self.assertEqual(deadpoint.load(FILES / "reduced/case.toml").hash, press.hash)
            with self.assertRaisesRegex(deadpoint.InputError, "exists"):
                press.save(Path(folder) / "again.toml")

    def test_quantities_of_pint(self):
        try:
            import pint
        except ImportError:
            self.skipTest("pint is not here")
        with warnings.catch_warnings():  # of pint about Python's own library
            warnings.simplefilter("ignore")
            units = pint.UnitRegistry()
        press = deadpoint.load(CASE)
        for quantity, text in ((units.Quantity(75.0, "rpm"), "75 rpm"), (units.Quantity(1.25, "turn/s"), "75 rpm")):
            press["operation.0.speed"] = quantity
            other = deadpoint.load(CASE, {"operation.0.speed": text})
            self.assertAlmostEqual(float(press["operation.0.speed"].split()[0]), float(other["operation.0.speed"].split()[0]),
                                   delta=1e-9)
        press["operation.0.force"] = units.Quantity(120.0, "kN")
        self.assertEqual(press["operation.0.force"], "120 kN")
        press["machine.ambient"] = units.Quantity(25.0, "degC")
        self.assertEqual(press["machine.ambient"], "25 degC")
        with self.assertRaises(deadpoint.InputError):
            press["operation.0.force"] = units.Quantity(120.0, "m")

    def test_mistakes_have_path_place_and_help_and_change_nothing(self):
        press = deadpoint.load(CASE)
        with self.assertRaises(deadpoint.InputError) as caught:
            press["operation.0.speed"] = "300 kg"
        error = caught.exception
        self.assertIsInstance(error, ValueError)
        self.assertEqual(error.path, "operation.0.speed")
        self.assertIn("rpm", error.help)
        self.assertIn("kg", str(error))
        self.assertEqual(press["operation.0.speed"], "60 rpm")
        with self.assertRaisesRegex(deadpoint.InputError, "speed"):
            press["operation.0.sped"] = "300 rpm"
        with self.assertRaises(KeyError):
            press["operation.7.speed"]
        with self.assertRaises(deadpoint.IoError) as caught:
            deadpoint.load(FILES / "none.toml")
        self.assertIn("none.toml", str(caught.exception))

    def test_all_mistakes_of_a_case_come_with_their_lines(self):
        with tempfile.TemporaryDirectory() as folder:
            broken = Path(folder) / "broken.toml"
            text = CASE.read_text().replace('force = "100 kN"', 'force = "100 kg"').replace('size = "30 mm"', 'size = "30 K"')
            broken.write_text(text)
            with self.assertRaises(deadpoint.InputError) as caught:
                deadpoint.load(broken)
            findings = {finding.path: finding for finding in caught.exception.findings}
            line = text.splitlines().index('force = "100 kg"') + 1
            self.assertEqual(findings["operation.0.force"].line, line)
            self.assertEqual(findings["operation.0.force"].column, 9)
            self.assertIn("numerics.size", findings)
            self.assertTrue(caught.exception.place.endswith(":9") or caught.exception.place)

    def test_a_changed_copy_leaves_the_press(self):
        press = deadpoint.load(CASE)
        fast = press.changed({"operation.0.speed": "120 rpm"})
        self.assertEqual((press["operation.0.speed"], fast["operation.0.speed"]), ("60 rpm", "120 rpm"))
        self.assertNotEqual(press.hash, fast.hash)


class Runs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.press = deadpoint.load(CASE)
        cls.rom = deadpoint.open_rom(ROM)
        cls.result = cls.rom.run(cls.press)

    def assert_same_error(self, mine, other):
        """The command sums the large model's conduction of factors, a module that stays does of matrices: rounding, of 300 K."""
        self.assertEqual(mine[0], other[0])
        np.testing.assert_allclose(mine[1:], other[1:], rtol=0, atol=1e-9)

    def test_files_are_those_of_the_command_byte_for_byte(self):
        with tempfile.TemporaryDirectory() as folder:
            saved = self.result.save(Path(folder) / "saved")
            for name in FIXED:
                self.assertEqual((FILES / "reduced" / name).read_bytes(), (saved.folder / name).read_bytes(), name)
            mine, other = saved.summary, json.loads((FILES / "reduced/summary.json").read_text())
            estimates = [summary["reduced"].pop("estimate") for summary in (mine, other)]
            for summary in (mine, other):
                summary.pop("timings_s")
            self.assertEqual(mine, other)
            self.assert_same_error(*(list(estimate.values()) for estimate in estimates))
            self.assertEqual(command("report", saved.folder, "-o", Path(folder) / "page.html"),
                             command("report", saved.folder, "-o", Path(folder) / "page.html", "--force"))
            with self.assertRaises(deadpoint.IoError):
                self.result.save(saved.folder)
            self.result.save(saved.folder, replace=True)

    def test_series_in_memory_are_those_of_the_files(self):
        opened = deadpoint.open(FILES / "reduced")
        np.testing.assert_allclose(self.result.gap.values, opened.gap.values, rtol=1e-8, atol=1e-12)  # nine digits
        self.assertEqual(self.result.gap.meaning, opened.gap.meaning)
        self.assertEqual(list(self.result.tables), ["history.csv", "contributions.csv", "gaps.csv"])
        self.assert_same_error(self.result.error, opened.error)
        self.assertGreater(self.result.error.gap, 0)

    def test_settings_change_one_run_as_set_does(self):
        with tempfile.TemporaryDirectory() as folder:
            command("run", "-q", CASE, "--reduced", ROM, "--set", "operation.0.speed=80 rpm", "--set", "machine.ambient=24 degC",
                    "-o", Path(folder) / "by-command")
            mine = self.rom.run(self.press, {"operation.0.speed": "80 rpm", "machine.ambient": "24 degC"})
            saved = mine.save(Path(folder) / "mine")
            self.assertEqual((Path(folder) / "by-command/history.csv").read_bytes(), (saved.folder / "history.csv").read_bytes())
        self.assertEqual(self.press["operation.0.speed"], "60 rpm")
        self.assertNotEqual(mine.gap.end, self.result.gap.end)

    def test_what_the_model_does_not_cover_is_said(self):
        result = self.rom.run(self.press, {"machine.ambient": "45 degC"})
        self.assertTrue(any(text.startswith("ambient") for text in result.outside))
        self.assertTrue(any("outside the range" in text for text in result.warnings))
        other = self.press.changed({"parts.bed.material": "steel"})
        self.assertTrue(self.rom.misfits(other))
        with self.assertRaisesRegex(deadpoint.InputError, "not the press that was reduced"):
            self.rom.run(other)

    def test_model_tells_what_it_is(self):
        self.assertEqual(self.rom.name, "starter press")
        self.assertEqual(self.rom.states, 40)
        self.assertIn("crank_pin.pin", self.rom.interfaces)
        self.assertIn("bed", self.rom.parts)
        ambient = next(one for one in self.rom.ranges if one.kind == "ambient")
        self.assertEqual((ambient.low, ambient.high), (-10, 10))
        self.assertIn(("E_SW", "um"), self.rom.outputs(self.press))
        self.assertIn(("slide", "degC"), self.rom.outputs(self.press))

    def test_bad_models_are_refused(self):
        with self.assertRaises(deadpoint.IoError):
            deadpoint.open_rom(FILES / "none.rom")
        with tempfile.TemporaryDirectory() as folder:
            short = Path(folder) / "short.rom"
            short.write_bytes(ROM.read_bytes()[:-100])
            with self.assertRaises(deadpoint.IoError):
                deadpoint.open_rom(short)
            shutil.copy(ROM, folder)
            with self.assertWarnsRegex(UserWarning, "press.large.rom' is missing"):
                result = deadpoint.open_rom(Path(folder) / "press.rom").run(self.press)
            self.assertIsNone(result.error)
            np.testing.assert_array_equal(result.gap.values, self.result.gap.values)

    def test_gradient_is_the_difference_of_runs(self):
        gradient = self.rom.gradient(self.press, ["friction.*.load_part", "friction.pins.viscous_part"], ["machine.ambient"])
        tight = {"numerics.time_tolerance": "1e-4 K"}

        def gap(settings):
            return self.rom.run(self.press, {**tight, **settings}, estimate=False, causes=False).gap.end

        # Central differences; they scatter by the steps, whose tolerance is tightened, and by nine digits of nothing.
        step = 0.02
        ends = [gap({"friction.pins.viscous_part": f"{0.4 * factor} W"}) for factor in (1 - step, 1 + step)]
        self.assertAlmostEqual(gradient["friction.pins.viscous_part"], (ends[1] - ends[0]) / (2 * step),
                               delta=0.01 * abs(gradient["friction.pins.viscous_part"]))
        ends = [gap({"machine.ambient": f"{celsius} degC"}) for celsius in (19.5, 20.5)]
        self.assertAlmostEqual(gradient["machine.ambient"], ends[1] - ends[0], delta=0.02 * abs(ends[1] - ends[0]))
        self.assertLess(gradient["friction.*.load_part"], 0)
        with self.assertRaisesRegex(deadpoint.InputError, "did you mean 'slide'"):
            self.rom.gradient(self.press, ["friction.*.load_part"], of="slid")
        with self.assertRaises(deadpoint.InputError):
            self.rom.gradient(self.press, ["friction.none.load_part"])

    def test_sensitivities_are_those_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            command("run", "-q", CASE, "--reduced", ROM, "--sensitivities", "-o", Path(folder) / "r")
            table = deadpoint.open(Path(folder) / "r").tables["sensitivities"]
        mine = self.rom.sensitivities(self.press)
        self.assertEqual([one.coefficient for one in mine], list(table["coefficient"]))
        np.testing.assert_allclose([one.gap for one in mine], table["E_SW per unit"], rtol=1e-8, atol=1e-15)

    def test_map_is_made_of_runs(self):
        found = self.rom.map(self.press, {"friction.pins.viscous_part": ["0.3 W", "0.5 W", "0.6 W"],
                                          "machine.ambient": ["18 degC", "22 degC"]}, threads=2)
        self.assertEqual(found.gap_end.shape, (3, 2))
        self.assertEqual(found.errors, [])
        one = self.rom.run(self.press, {"friction.pins.viscous_part": "0.5 W", "machine.ambient": "22 degC"}, estimate=False)
        self.assertAlmostEqual(found.gap_end[1, 1], one.gap.end, delta=1e-9 * abs(one.gap.end))
        self.assertAlmostEqual(found.probes["slide"][1, 1], one.probes["slide"].end, delta=1e-9)
        bad = self.rom.map(self.press, {"operation.0.speed": ["60 rpm", "60 kg"]})
        self.assertTrue(np.isnan(bad.gap_end[1]) and not np.isnan(bad.gap_end[0]))
        self.assertEqual(len(bad.errors), 1)

    def test_a_map_reads_its_case_once(self):
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "case.toml"
            shutil.copy(CASE, case)
            press = deadpoint.load(case, {"operation.0.duration": "2 min"})

            class Receiver:
                def stage(self, name):
                    case.write_text("no case")  # it has been read when the points begin

                def progress(self, fraction, detail):
                    pass

                def warn(self, text):
                    pass

            found = self.rom.map(press, {"operation.0.speed": ["50 rpm", "60 rpm"]}, progress=Receiver())
            self.assertEqual(found.errors, [])
            self.assertAlmostEqual(found.gap_end[1], self.rom.run(self.press, {"operation.0.duration": "2 min"}).gap.end, delta=1e-9)
        with self.assertRaisesRegex(deadpoint.InputError, "too large"):
            self.rom.map(self.press, {f"operation.{k}.speed": range(1000) for k in range(3)})

    def test_threads_run_models_at_once(self):
        models = [self.rom, deadpoint.open_rom(ROM)]
        speeds = ["50 rpm", "60 rpm", "70 rpm", "80 rpm"]
        alone = [self.rom.run(self.press, {"operation.0.speed": speed}).gap.values for speed in speeds]
        found = {}

        def work(index):
            for repeat in range(2):
                model = models[(index + repeat) % 2]
                found[index, repeat] = model.run(self.press, {"operation.0.speed": speeds[index]}).gap.values

        threads = [threading.Thread(target=work, args=(index,)) for index in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for index in range(4):
            for repeat in range(2):
                np.testing.assert_array_equal(found[index, repeat], alone[index])

    def test_the_interpreter_goes_on_while_a_run_computes(self):
        ticks, stop = [], threading.Event()

        def tick():
            while not stop.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.002)

        thread = threading.Thread(target=tick)
        thread.start()
        start = time.perf_counter()
        self.rom.run(self.press)
        end = time.perf_counter()
        stop.set()
        thread.join()
        inside = sum(start < at < end for at in ticks)
        self.assertGreater(inside, 0.05 * (end - start) / 0.002)  # none but the first if the lock were held

    def test_progress_reaches_any_receiver_and_its_error_comes_back(self):
        class Receiver:
            stages = []

            def stage(self, name):
                self.stages.append(name)

            def progress(self, fraction, detail):
                pass

            def warn(self, text):
                raise RuntimeError(text)

        self.rom.run(self.press, progress=Receiver())
        self.assertIn("time steps", Receiver.stages)
        with self.assertRaisesRegex(RuntimeError, "outside the range"):
            self.rom.run(self.press, {"machine.ambient": "45 degC"}, progress=Receiver())

    def test_memory_stays(self):
        def resident():
            return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

        press = self.press.changed({"operation.0.duration": "2 min"})

        def runs(count):
            for _ in range(count):
                self.rom.run(press, estimate=False, causes=False).gap
            gc.collect()

        runs(200)
        before = resident()
        runs(int(os.environ.get("DEADPOINT_LEAK_RUNS", "800")))
        self.assertLess(resident() - before, 5e6)


CALIBRATION = """
format = 1
name = "long"
[[parameters]]
name = "pins"
keys = ["friction.pins.*_part"]
factor = 2
[[parameters]]
name = "film"
keys = ["surfaces.*.film.coefficient"]
factor = 2
[[runs]]
name = "r"
data = "log.csv"
[[sensors]]
columns = ["slide"]
noise = "0.1 K"
[options]
starts = 500
"""


class Interrupts(unittest.TestCase):
    def stopped_after(self, call, first):
        """Seconds from Ctrl-C to the KeyboardInterrupt of a call, which has begun once `first` seconds have passed."""
        script = f"""
import deadpoint, time
press, rom = deadpoint.load({str(CASE)!r}), deadpoint.open_rom({str(ROM)!r})
print("begun", flush=True)
try:
    {call}
    print("done", flush=True)
except KeyboardInterrupt:
    print(time.time(), flush=True)
"""
        with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as child:
            self.assertEqual(child.stdout.readline().strip(), "begun")
            time.sleep(first)
            asked = time.time()
            child.send_signal(signal.SIGINT)
            return float(child.stdout.readline()) - asked

    def test_ctrl_c_reaches_every_long_call_within_a_second(self):
        with tempfile.TemporaryDirectory() as folder:
            calibration = Path(folder) / "calibration.toml"
            calibration.write_text(CALIBRATION)
            rows = [f"{60 * k},{20 + 0.05 * k}" for k in range(1, 180)]
            (Path(folder) / "log.csv").write_text("\n".join(["time [s],slide [degC]", *rows]))
            calls = {
                "while True: rom.derivatives(press, ['friction.*.load_part'] * 40, threads=1)": 1,
                "while True: rom.sensitivities(press)": 1,
                f"deadpoint.calibrate(press, {str(calibration)!r}, {str(Path(folder) / 'c')!r}, reduced=rom)": 2,
                f"press.reduce({str(Path(folder) / 'new.rom')!r}, size=2)": 3,
            }
            for call, first in calls.items():
                self.assertLess(self.stopped_after(call, first), 1.0, call)

    def test_ctrl_c_keeps_what_is_done(self):
        script = f"""
import deadpoint
class Receiver:
    def stage(self, name):
        print(name, flush=True)
    def progress(self, fraction, detail): pass
    def warn(self, text): pass
rom = deadpoint.open_rom({str(ROM)!r})
try:
    rom.map({str(CASE)!r}, {{"operation.0.speed": [f"{{40 + 0.01 * k}} rpm" for k in range(5000)]}}, progress=Receiver())
except KeyboardInterrupt as stopped:
    import numpy
    done = int(numpy.isfinite(stopped.result.gap_end).sum())
    print(type(stopped).__name__, 0 < done < 5000, flush=True)
"""
        child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
        with child.stdout as out:
            self.assertEqual(out.readline().strip(), "points")
            time.sleep(1)
            child.send_signal(signal.SIGINT)
            self.assertEqual(out.readline().strip(), "Interrupted True")
        self.assertEqual(child.wait(), 0)


if __name__ == "__main__":
    unittest.main()
