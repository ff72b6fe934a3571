"""Requirement: the notebooks run as they stand, with the files that their first cell names."""
import contextlib
import io
import json
import os
import shutil
import tempfile
import unittest
import warnings
from pathlib import Path

from common import FILES, SOURCE

try:
    import matplotlib.pyplot as plt
except ImportError:
    plt = None


def cells_of(name):
    notebook = json.loads((SOURCE / "examples/notebooks" / f"{name}.ipynb").read_text())
    return ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]


@unittest.skipIf(plt is None, "matplotlib is not here")
class Notebooks(unittest.TestCase):
    def execute(self, name):
        """Runs all cells; returns what they print and what they have defined."""
        before, out, space = Path.cwd(), io.StringIO(), {"__name__": name}
        with tempfile.TemporaryDirectory() as folder:
            for file in ("case.toml", "press.rom", "press.large.rom"):
                shutil.copy(FILES / file, folder)
            shutil.copytree(FILES / "full", Path(folder) / "results")
            os.chdir(folder)
            try:
                with contextlib.redirect_stdout(out), warnings.catch_warnings():
                    warnings.simplefilter("ignore")  # of matplotlib about other libraries
                    for number, cell in enumerate(cells_of(name)):
                        exec(compile(cell, f"{name}, cell {number}", "exec"), space)
            finally:
                os.chdir(before)
                plt.close("all")
        return out.getvalue(), space

    def test_first_steps(self):
        text, _ = self.execute("first-steps")
        self.assertIn("um at the end", text)
        self.assertIn("degC at [", text)
        self.assertIn("operation.0.speed - ", text)

    def test_reduced_study(self):
        text, space = self.execute("reduced-study")
        self.assertIn("10000 points", text)
        self.assertEqual(space["gap"].shape, (100, 100))

    def test_calibration(self):
        text, space = self.execute("calibration")
        self.assertIn("journals: 1.", text)
        self.assertLess(space["worst"], 0.5)


if __name__ == "__main__":
    unittest.main()
