"""deadpoint: thermal drift of mechanical presses at bottom dead point.

>>> import deadpoint
>>> press = deadpoint.load("case.toml")
>>> press["operation.0.speed"] = "300 rpm"
>>> rom = deadpoint.open_rom("press.rom")
>>> rom.run(press).gap
"""
from deadpoint._errors import (
    ConvergenceError,
    DomainError,
    Error,
    Finding,
    InputError,
    Interrupted,
    IoError,
    NameUnknown,
)
from deadpoint._fields import Fields
from deadpoint._loads import Conductance, Film, FrictionHeat, Heat, Loads, Mesh, TurnSeries
from deadpoint._press import Press, load
from deadpoint._progress import Receiver
from deadpoint._reduced import version as _version
from deadpoint._results import Result, StatedError, Study, open, open_study
from deadpoint._rom import Derivatives, Map, Output, Range, Rom, Sensitivity, open_rom
from deadpoint._series import Named, Series
from deadpoint._studies import calibrate, compare, optimise, sensitivity, sweep
from deadpoint._tables import Table, TableColumn, Tables

__version__ = _version()
__all__ = [
    "Conductance", "ConvergenceError", "Derivatives", "DomainError", "Error", "Fields", "Film", "Finding",
    "FrictionHeat", "Heat", "InputError", "Interrupted", "IoError", "Loads", "Map", "Mesh", "NameUnknown", "Named",
    "Output", "Press", "Range", "Receiver", "Result", "Rom", "Sensitivity", "Series", "StatedError", "Study", "Table",
    "TableColumn", "Tables", "TurnSeries", "calibrate", "compare", "load", "open", "open_rom", "open_study", "optimise",
    "sensitivity", "sweep",
]
