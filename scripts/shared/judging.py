"""Verdicts on predictions: how near a value is, whether it is better than a baseline, and which way a series goes."""

import math

NEAR = 0.2  # relative error up to which a figure counts as reproduced
BETTER = 0.9  # of the baseline's error: above it a prediction is no better
EVEN = 0.01  # relative spread below which a series makes no difference

REPRODUCED, NO_BETTER, DIFFERS = "reproduced", "no better than base", "differs"


def verdict(relative_error, error, baseline_error=None):
    """Of one figure. `baseline_error` is that of the baseline in its place; None: there is no baseline."""
    if abs(relative_error) > NEAR:
        return DIFFERS
    if baseline_error is not None and abs(error) > BETTER * abs(baseline_error):
        return NO_BETTER
    return REPRODUCED


def rms(values):
    """Root mean square of at least one value."""
    values = list(values)
    return math.sqrt(sum(value ** 2 for value in values) / len(values))


def skill(errors, baseline_errors):
    """Root mean square errors of a prediction and of its baseline, and which is better in a word."""
    own, base = rms(errors), rms(baseline_errors)
    word = "worse" if own > base / BETTER else "better" if own < BETTER * base else "no better"
    return own, base, word


def trend(values):
    """Which way a series of at least two values goes."""
    pairs = list(zip(values, values[1:]))
    if max(values) - min(values) < EVEN * max(map(abs, values)):
        return "no change"
    if all(b > a for a, b in pairs):
        return "grows"
    if all(b < a for a, b in pairs):
        return "falls"
    peak = values.index(max(values))
    up_down = 0 < peak < len(values) - 1 and all((b > a) == (i < peak) for i, (a, b) in enumerate(pairs))
    return "grows, then falls" if up_down else "no one trend"
