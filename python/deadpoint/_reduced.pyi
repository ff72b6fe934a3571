import pathlib
from collections.abc import Sequence
from typing import Any, TypedDict

import numpy as np
import numpy.typing as npt

from deadpoint._errors import Finding
from deadpoint._progress import Receiver

_Array = npt.NDArray[np.float64]

class _Info(TypedDict):
    name: str
    version: str
    case_hash: str
    large_file: str
    states: int
    unknowns: int
    cells: int
    has_chain: bool
    box: list[tuple[str, int, float, float]]
    errors: list[tuple[str, float, float]]
    parts: list[str]
    interfaces: list[str]

class _Sensitivities(TypedDict):
    time: float
    has_gap: bool
    probes: list[str]
    rows: list[tuple[str, float, str, float, float, list[float]]]

class _Map(TypedDict):
    gap_end: _Array
    gap_largest: _Array
    warm_up: _Array
    probes: dict[str, _Array]
    errors: list[str]
    warnings: list[str]
    interrupted: bool

def version() -> str: ...
def schema() -> dict[str, tuple[str, list[tuple[str, str, str, str]]]]: ...
def dimensions() -> dict[str, str]: ...

class Case:
    def __init__(self, file: str | pathlib.Path, settings: Sequence[str], size: float, allow_outside: bool) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def hash(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def findings(self) -> list[Finding]: ...

class _Piece(TypedDict):
    points: npt.NDArray[np.float64]
    connectivity: npt.NDArray[np.uint32]
    offsets: npt.NDArray[np.uint32]
    types: npt.NDArray[np.uint8]
    point_data: dict[str, npt.NDArray[Any]]
    cell_data: dict[str, npt.NDArray[Any]]

class Files:
    def __init__(self, folder: str | pathlib.Path) -> None: ...
    @property
    def names(self) -> list[str]: ...
    def check(self) -> None: ...
    def read(self, name: str) -> bytes | None: ...
    def field_times(self) -> list[tuple[float, str]]: ...
    def fields(self, name: str) -> list[_Piece]: ...

class Run:
    def tables(self) -> dict[str, list[tuple[str, str, str, Any]]]: ...
    def summary(self) -> str: ...
    def write(self, folder: str | pathlib.Path, replace: bool) -> None: ...
    @property
    def case_text(self) -> str: ...
    @property
    def interrupted(self) -> bool: ...
    @property
    def seconds(self) -> float: ...
    @property
    def warnings(self) -> list[str]: ...

class Rom:
    def __init__(self, file: str | pathlib.Path) -> None: ...
    def info(self) -> _Info: ...
    def outputs(self, case: Case) -> list[tuple[str, str]]: ...
    def misfits(self, case: Case) -> list[str]: ...
    def run(self, case: Case, large: Rom | None, figures_only: bool, receiver: Receiver | None) -> Run: ...
    def sensitivities(self, case: Case, receiver: Receiver | None) -> _Sensitivities: ...
    def derivatives(
        self, case: Case, keys: Sequence[tuple[str, list[str], bool]], threads: int
    ) -> tuple[_Array, list[_Array], list[list[_Array]]]: ...
    def map(
        self, case: Case, settings: Sequence[Sequence[str]], threads: int, receiver: Receiver | None
    ) -> _Map: ...
