"""Charts of a result with matplotlib, which is imported here only."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterable

    from matplotlib.axes import Axes

    from deadpoint._results import Result
    from deadpoint._series import Series


class Plot:
    """Charts over time. Each returns the axes, so that titles and limits can be changed."""

    def __init__(self, result: Result) -> None:
        self._result = result

    def drift(self, axes: Axes | None = None) -> Axes:
        """E_SW and the other dimensions of the chain [um] over the time [h]."""
        dimensions = self._result.dimensions
        self._result.gap  # says why there is none
        axes = self._lines(dimensions.values(), "change [um]", axes)
        axes.get_lines()[0].set_linewidth(2.5)
        return axes

    def temperatures(self, axes: Axes | None = None) -> Axes:
        """Probes [degC] over the time [h]."""
        return self._lines(self._result.probes.values(), "temperature [degC]", axes)

    def heat(self, axes: Axes | None = None) -> Axes:
        """Friction heat of the joints [W] over the time [h]."""
        return self._lines(self._result.joint_heat.values(), "friction heat [W]", axes)

    def contributions(self, axes: Axes | None = None, most: int = 6) -> Axes:
        """Contributions of the strongest parts to E_SW [um] over the time [h].

        :param most: number of parts that get a line of their own; the others are summed
        """
        parts = list(self._result.contributions.values())
        axes = self._lines(parts[:most], "share of E_SW [um]", axes)
        if len(parts) > most:
            rest = np.sum([part.values for part in parts[most:]], axis=0)
            axes.plot(parts[0].hours, rest, "--", color="0.5", label="all others")
            axes.legend()
        return axes

    def _lines(self, series: Iterable[Series], label: str, axes: Axes | None) -> Axes:
        if axes is None:
            axes = _new_axes()
        for one in series:
            axes.plot(one.hours, one.values, label=one.name)
        axes.set_xlabel("time [h]")
        axes.set_ylabel(label)
        axes.set_title(self._result.name)
        axes.grid(alpha=0.3)
        axes.legend()
        return axes


def _new_axes() -> Any:
    import matplotlib.pyplot

    return matplotlib.pyplot.subplots(figsize=(7, 4))[1]
