"""Series: one quantity of one thing over time, with its unit and meaning."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from deadpoint._errors import unknown

Array = npt.NDArray[np.float64]


class Series:
    """One quantity of one thing over the time of a run.

    ``numpy.asarray(series)`` gives the values. Arithmetic works on the values too: ``series - series.start``.
    """

    def __init__(self, name: str, kind: str, unit: str, meaning: str, time: Array, values: Array) -> None:
        self.name = name
        """Name of the thing in the case: ``crank_pin``; of the dimension: ``E_SW``."""
        self.kind = kind
        """What it is: ``probe_temperature``, ``joint_heat``, ``dimension`` and so on, as in docs/result-files.md."""
        self.unit = unit
        """Unit of the values: ``um``, ``degC``, ``W``."""
        self.meaning = meaning
        """One sentence that says what the values are."""
        self.time = time
        """Times since the start of the run [s], ascending; shape (n,)."""
        self.values = values
        """Values [unit]; shape (n,)."""

    @property
    def hours(self) -> Array:
        """Times [h]; shape (n,)."""
        return self.time / 3600.0

    @property
    def start(self) -> float:
        """First value [unit]."""
        return float(self.values[0])

    @property
    def end(self) -> float:
        """Last value [unit]."""
        return float(self.values[-1])

    @property
    def largest(self) -> float:
        """Value of largest magnitude, with its sign [unit]."""
        sizes = np.where(np.isnan(self.values), -1.0, np.abs(self.values))
        return float(self.values[int(np.argmax(sizes))])

    def at(self, time: npt.ArrayLike) -> Any:
        """Values at other times, linear in between.

        :param time: time or times since the start [s], within the run
        :returns: a number or an array of the same shape [unit]
        :raises deadpoint.InputError: for a time outside the run
        """
        from deadpoint._errors import InputError

        try:
            wanted = np.asarray(time, dtype=float)
        except ValueError as error:
            raise InputError(f"{self.name}: {time!r} is no time\n  help: give seconds since the start") from error
        if not ((wanted >= self.time[0]) & (wanted <= self.time[-1])).all():
            raise InputError(
                f"{self.name}: time {wanted.min():g}..{wanted.max():g} s is outside the run\n"
                f"  help: it has {self.time[0]:g} to {self.time[-1]:g} s"
            )
        found = np.interp(wanted, self.time, self.values)
        return float(found) if np.ndim(time) == 0 else found

    def __array__(self, dtype: Any = None, copy: Any = None) -> Array:
        return np.array(self.values, dtype=dtype, copy=True) if copy else np.asarray(self.values, dtype=dtype)

    def __len__(self) -> int:
        return len(self.values)

    def __iter__(self) -> Iterator[float]:
        return iter(self.values.tolist())

    def __getitem__(self, index: Any) -> Any:
        return self.values[index]

    def __sub__(self, other: npt.ArrayLike) -> Array:
        return np.subtract(self.values, np.asarray(other, dtype=float))

    def __add__(self, other: npt.ArrayLike) -> Array:
        return np.add(self.values, np.asarray(other, dtype=float))

    def __mul__(self, other: npt.ArrayLike) -> Array:
        return np.multiply(self.values, np.asarray(other, dtype=float))

    __rmul__ = __mul__
    __radd__ = __add__

    def __repr__(self) -> str:
        return f"<Series {self.name} [{self.unit}]: {self.start:.4g} to {self.end:.4g}, {len(self)} times; {self.meaning}>"


class Named(Mapping[str, Series]):
    """Series by name. An unknown name raises an error that suggests a similar one."""

    def __init__(self, kind: str, series: dict[str, Series]) -> None:
        self._kind = kind
        self._series = series

    def __getitem__(self, name: str) -> Series:
        if name not in self._series:
            raise unknown(self._kind, name, self._series)
        return self._series[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._series)

    def __len__(self) -> int:
        return len(self._series)

    def __repr__(self) -> str:
        return "\n".join(repr(series) for series in self._series.values()) or f"<no {self._kind}>"
