"""Requirement: the verdicts that scripts draw from results are right on cases worked out by hand."""

import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from shared import judging  # noqa: E402


class Judging(unittest.TestCase):
    def test_verdict(self):
        self.assertEqual(judging.verdict(0.2, 1), "reproduced")
        self.assertEqual(judging.verdict(-0.21, 1), "differs")
        self.assertEqual(judging.verdict(0.1, 1.8, 2), "reproduced")  # 0.9 of the baseline's error
        self.assertEqual(judging.verdict(0.1, -1.81, 2), "no better than base")
        self.assertEqual(judging.verdict(0.1, 1, -2), "reproduced")

    def test_skill(self):
        self.assertEqual(judging.skill([3, 4], [5, 5])[:2], (math.sqrt(12.5), 5))
        self.assertEqual([judging.skill([1], [base])[2] for base in (0.8, 1.0, 1.2)], ["worse", "no better", "better"])

    def test_trend(self):
        for values, wanted in (([1, 2, 3], "grows"), ([3, 2, 1], "falls"), ([1, 3, 2], "grows, then falls"),
                               ([3, 1, 2], "no one trend"), ([1, 1.005], "no change"), ([-3, -2], "grows")):
            self.assertEqual(judging.trend(values), wanted, values)


if __name__ == "__main__":
    unittest.main()
