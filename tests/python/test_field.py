"""Requirement: full runs, loads and heat in Python are those of the command; Ctrl-C keeps what a run has computed."""
import gc
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

import deadpoint
from common import CASE, FILES, command
from deadpoint._press import _text_of as text_of

COMMAND = os.environ["DEADPOINT_COMMAND"]
SETTINGS = {"operation.0.duration": "20 min", "output.field_times": ["10 min", "20 min"]}  # as make_files.sh




def files_below(folder):
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


class Full(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.press = deadpoint.load(CASE, SETTINGS)

    def test_files_are_those_of_the_command_byte_for_byte(self):
        with tempfile.TemporaryDirectory() as folder:
            result = self.press.run(Path(folder) / "full", size=4)
            for name in ("case.toml", "history.csv", "contributions.csv", "gaps.csv", "causes.csv", "fields_0001.vtu", "fields.pvd",
                         "state.bin", "view.json"):
                self.assertEqual((FILES / "full" / name).read_bytes(), (result.folder / name).read_bytes(), name)
            self.assertEqual(files_below(result.folder), files_below(FILES / "full"))  # page, fields and checkpoint too
            with self.assertRaises(deadpoint.IoError):
                self.press.run(Path(folder) / "full", size=4)

            # A run goes on from a folder, and a changed press uses the same mesh.
            faster = self.press.changed({"operation.0.duration": "10 min", "operation.0.speed": "90 rpm"})
            self.press.update(faster.settings)
            later = self.press.run(size=4, start_from=Path(folder) / "full")
            self.assertEqual(later.fields().temperature.shape, result.fields().temperature.shape)
            self.press.update({"operation.0.speed": "60 rpm", "operation.0.duration": "20 min"})
            self.assertAlmostEqual(later.probes["slide"].start, result.probes["slide"].end, delta=1e-6)  # nine digits in the file
            self.assertIn("mesh", later.summary["timings_s"])
            saved = later.save(Path(folder) / "later")
            np.testing.assert_allclose(saved.gap.values, later.gap.values, atol=1e-6)  # nine digits in the file
            self.assertEqual(saved.fields().temperature.shape, later.fields().temperature.shape)
            self.assertLess(later.gap.end, 0)
            kept = later.folder
            del later
            gc.collect()
            self.assertFalse(kept.exists())

    def test_mesh_is_that_of_the_run(self):
        mesh = self.press.mesh(size=4)
        self.assertEqual(mesh.cells, deadpoint.open(FILES / "full").summary["model"]["cells"])
        self.assertEqual(sum(mesh.parts.values()), mesh.cells)

    def test_check_finds_what_only_the_mesh_shows(self):
        self.assertEqual(self.press.check(size=4), [])
        wrong = self.press.changed({"joints.crank_pin.interfaces.0.diameter": "70 mm"})
        found = wrong.check(size=4)
        self.assertTrue(any(one.path.startswith("joints.crank_pin") and one.severity == "error" for one in found), found)
        with self.assertRaises(deadpoint.InputError) as caught:
            wrong.run(size=4)
        self.assertTrue(caught.exception.path.startswith("joints.crank_pin"))

    def test_every_warning_of_the_command_arrives(self):
        # Of reading (an interval longer than the run), of the mesh (a mass) and of the loads (less force than the slide weighs).
        changes = {**SETTINGS, "bodies.slide.mass": "1 t", "operation.0.force": "10 N", "output.history_interval": "5 h"}
        settings = [argument for key, value in changes.items() for argument in ("--set", f"{key}={text_of(value)}")]
        shown = subprocess.run([COMMAND, "check", "--size", "4", CASE, *settings], capture_output=True, text=True, check=True)
        count = int(re.search(r"no errors, (\d+) warnings", shown.stdout).group(1))
        press = deadpoint.load(CASE, changes)
        found = press.check(size=4)
        self.assertEqual([one.severity for one in found], ["warning"] * count, found)
        self.assertGreaterEqual({one.path for one in found}, {"bodies.slide.mass", "output.history_interval"})
        for one in found:
            self.assertIn(one.message.partition("\n")[0], shown.stderr)

        # Both runs of one mesh have them all, and so have their files.
        short = {"operation.0.duration": "1 min", "output.field_times": []}
        settings += [argument for key, value in short.items() for argument in ("--set", f"{key}={text_of(value)}")]
        press.update(short)
        with tempfile.TemporaryDirectory() as folder:
            command("run", "-q", "--size", "4", CASE, *settings, "-o", Path(folder) / "command")
            expected = deadpoint.open(Path(folder) / "command").warnings
            self.assertTrue(any("bodies.slide.mass" in text for text in expected))
            for _ in range(2):
                self.assertEqual(press.run(size=4).warnings, expected)

    def test_loads_are_those_of_the_command(self):
        loads = self.press.loads()
        with tempfile.TemporaryDirectory() as folder:
            command("loads", "-q", CASE, "-o", Path(folder) / "loads")
            table = deadpoint.open_study(Path(folder) / "loads").tables["joints"]
        self.assertAlmostEqual(loads.stroke, 0.08, delta=1e-12)  # twice the throw of 40 mm
        np.testing.assert_allclose(np.interp(table["time"], loads.time, loads.of("slide", "height")), table["slide height"],
                                   atol=2e-5)  # other places of the crank; linear in between
        # The process presses with 100 kN at bottom dead point; the rod's and slide's weight and inertia are some kN.
        self.assertAlmostEqual(np.abs(loads.of("crank_pin", "force y")).max(), 1e5, delta=5e3)
        with self.assertRaisesRegex(deadpoint.InputError, "did you mean"):
            loads.of("crank_pin", "force yy")

    def test_heat_states_the_laws(self):
        heat = self.press.heat()
        given = {(one.joint, one.interface): one.conductance for one in heat.conductances}
        self.assertAlmostEqual(given["crank_pin", "pin"], 1 / 3e-4, delta=1e-9)  # stated as a resistance of 3e-4 m2 K/W
        pins = next(one for one in heat.friction if one.name == "pins")
        self.assertEqual(pins.heat.shape, heat.temperatures.shape)
        self.assertTrue((np.diff(pins.heat) < 0).all())  # oil thins as it warms
        with self.assertRaisesRegex(deadpoint.InputError, "no segment 7"):
            self.press.heat(segment=7)


class Interrupts(unittest.TestCase):
    def test_ctrl_c_keeps_what_is_done(self):
        with tempfile.TemporaryDirectory() as folder:
            script = f"""
import deadpoint
class Receiver:
    def stage(self, name): pass
    def progress(self, fraction, detail):
        if detail.startswith("t ="):
            print("step", flush=True)
    def warn(self, text): pass
press = deadpoint.load({str(CASE)!r}, {{"numerics.max_step": "5 s"}})
try:
    press.run({str(Path(folder) / "r")!r}, size=4, progress=Receiver())
except KeyboardInterrupt as stopped:
    result = stopped.result
    print(type(stopped).__name__, result.interrupted, 0 < result.time[-1] < 10800, result.folder.exists(), flush=True)
"""
            with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as child:
                self.assertEqual(child.stdout.readline().strip(), "step")
                time.sleep(0.3)
                child.send_signal(signal.SIGINT)
                lines = [line.strip() for line in child.stdout if line.strip() != "step"]
            self.assertEqual(lines, ["Interrupted True True True"])
            self.assertEqual(child.returncode, 0)


class Verbs(unittest.TestCase):
    def test_a_sweep_of_a_press_on_the_reduced_model(self):
        press = deadpoint.load(CASE, {"operation.0.duration": "1 h"})
        rom = deadpoint.open_rom(FILES / "press.rom")
        with tempfile.TemporaryDirectory() as folder:
            study = deadpoint.sweep(press, Path(folder) / "s", {"operation.0.speed": ["50 rpm", "70 rpm"]}, reduced=rom)
            table = study.tables["sweep"]
            ends = [rom.run(press, {"operation.0.speed": speed}).gap.end for speed in ("50 rpm", "70 rpm")]
            np.testing.assert_allclose(table["E_SW at end"], ends, rtol=1e-6)  # nine digits in the table
            self.assertIn("<table>", study._repr_html_())

    def test_errors_of_the_command_keep_their_kind(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(deadpoint.IoError) as caught:
                deadpoint.sweep(Path(folder) / "none.toml", Path(folder) / "s")
            self.assertIn("none.toml", str(caught.exception))
            with self.assertRaises(deadpoint.InputError):
                deadpoint.sensitivity(CASE, FILES / "press.rom", Path(folder) / "s")


if __name__ == "__main__":
    unittest.main()
