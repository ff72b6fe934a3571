"""Mesh, loads and heat of a press, before any run. All values are in SI units."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from deadpoint._errors import unknown
from deadpoint._series import Array

if TYPE_CHECKING:
    from deadpoint import _field


class Mesh(NamedTuple):
    """Size of a mesh."""

    cells: int
    """Number of cells."""
    nodes: int
    """Number of nodes."""
    half_model: bool
    """Only half of the press is modelled."""
    parts: dict[str, int]
    """Number of cells of each part."""


class TurnSeries(NamedTuple):
    """One quantity of one thing over a turn of the crank."""

    kind: str
    """``slide``, ``drive``, ``joint``."""
    name: str
    """Of the thing in the case: ``crank_pin``."""
    quantity: str
    """``height``, ``speed``, ``force x``."""
    unit: str
    """SI unit of the values."""
    values: Array
    """Values at :attr:`Loads.time`; shape (n,)."""


class Loads(NamedTuple):
    """Motion and forces over a turn of the crank."""

    segment: int
    """Of the operation, from 0."""
    speed: float
    """Mean speed of the crank [rad/s]."""
    stroke: float
    """Of the slide [m]."""
    time: Array
    """Times over the turn [s]; shape (n,)."""
    angle: Array
    """Of the crank from its assembled position [rad]; shape (n,)."""
    series: list[TurnSeries]
    """Everything that moves or carries load."""
    warnings: list[str]
    """What must be known to judge them."""

    def of(self, name: str, quantity: str) -> Array:
        """Values of one quantity: ``loads.of("crank_pin", "force y")`` [SI]; shape (n,).

        :raises deadpoint.InputError: if there is no such series; it suggests a similar one
        """
        for one in self.series:
            if (one.name, one.quantity) == (name, quantity):
                return one.values
        known = [f"{one.name} {one.quantity}" for one in self.series]
        raise unknown("series", f"{name} {quantity}", known)


class FrictionHeat(NamedTuple):
    """Friction heat of a law over the temperature."""

    name: str
    """In [friction] of the case."""
    law: str
    """Name of the law."""
    lubricant: str
    """Name of the lubricant."""
    joints: list[str]
    """Joints that name it."""
    heat: Array
    """At :attr:`Heat.temperatures`, of the whole press [W]; shape (n,)."""


class Conductance(NamedTuple):
    """Contact conductance of an interface."""

    joint: str
    """Name of the joint."""
    interface: str
    """Name of the interface in it."""
    law: str
    """Name of the law, or ``given``."""
    area: float
    """In contact, of the model [m2]."""
    conductance: float
    """Of both sides in series [W/m2/K]."""


class Film(NamedTuple):
    """Coefficient of a surface at one rise above the air."""

    surface: str
    """Name of the surface."""
    law: str
    """Name of the law."""
    area: float
    """Of the model [m2]."""
    ambient: float
    """[K]"""
    speed: float
    """Of the surface's law [rad/s, or m/s if it moves]."""
    rise: float
    """Above the ambient [K]."""
    coefficient: float
    """Convection and radiation [W/m2/K]."""
    in_range: bool
    """Within the law's tested range."""


class Heat(NamedTuple):
    """Values of the laws of a case, before any field is solved."""

    segment: int
    """Of the operation, from 0."""
    speed: float
    """Of the crank [rad/s]."""
    temperatures: Array
    """Of the joints [K]; shape (n,)."""
    friction: list[FrictionHeat]
    """By law."""
    conductances: list[Conductance]
    """By interface."""
    films: list[Film]
    """By surface and rise."""
    warnings: list[str]
    """What must be known to judge them."""


def loads_of(found: _field._Loads) -> Loads:
    """For deadpoint itself."""
    series = [TurnSeries(kind, name, quantity, unit, np.array(values)) for kind, name, quantity, unit, values in found["series"]]
    return Loads(found["segment"], found["speed"], found["stroke"], np.array(found["time"]), np.array(found["angle"]), series,
                 found["warnings"])


def heat_of(found: _field._Heat) -> Heat:
    """For deadpoint itself."""
    friction = [FrictionHeat(name, law, oil, joints, np.array(heat)) for name, law, oil, joints, heat in found["joints"]]
    return Heat(found["segment"], found["speed"], np.array(found["temperatures"]), friction,
                [Conductance(*row) for row in found["conductances"]], [Film(*row) for row in found["films"]], found["warnings"])
