"""Requirement: what scripts conclude from results, verdicts and fits, is right on cases worked out by hand."""

import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from shared import fitting, judging  # noqa: E402


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


class Fitting(unittest.TestCase):
    def test_solve_needs_pivoting(self):
        # 0 x + 2 y = 4, 3 x + y = 5
        self.assertEqual(fitting.solve([[0, 2], [3, 1]], [4, 5]), [1, 2])

    def test_jacobian_of_a_linear_model(self):
        columns = fitting.jacobian(lambda p: {"a": 2 * p[0], "b": p[0] - 3 * p[1]}, [1, 1], {"a": 2, "b": -2})
        for found, wanted in zip(columns, ([2, 1], [0, -3])):
            for value, exact in zip(found, wanted):
                self.assertAlmostEqual(value, exact, delta=1e-12)  # rounding: the model is linear

    def test_fit_finds_two_rates(self):
        # Two decays, exact data: the fit must find their rates to the step at which it calls itself converged.
        def model(logs):
            rates = [math.exp(value) for value in logs]
            return {f"{k} {t}": math.exp(-rate * t) - math.exp(-exact * t)
                    for k, (rate, exact) in enumerate(zip(rates, (0.5, 2.0))) for t in (0.3, 1.0)}
        logs, differences, why = fitting.fit(model, [0.0, 0.0], 30, (-5, 5))
        self.assertIn("converged", why)
        for value, exact in zip(logs, (0.5, 2.0)):
            self.assertAlmostEqual(value, math.log(exact), delta=fitting.SMALLEST_STEP)
        self.assertLess(fitting.sum_of_squares(differences), 1e-5)

    def test_fit_keeps_its_bounds_and_its_number_of_iterations(self):
        far = lambda p: {"a": p[0] - 100}  # noqa: E731
        logs, _, _ = fitting.fit(far, [0.0], 30, (-1, 2))
        self.assertEqual(logs, [2])
        self.assertIn("not converged after 1 iterations", fitting.fit(far, [0.0], 1, (-1, 200))[2])


if __name__ == "__main__":
    unittest.main()
