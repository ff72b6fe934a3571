import pathlib
from typing import TypedDict

from deadpoint._errors import Finding
from deadpoint._progress import Receiver
from deadpoint._reduced import Case, Run

class _Mesh(TypedDict):
    cells: int
    nodes: int
    half_model: bool
    parts: dict[str, int]

class _Loads(TypedDict):
    segment: int
    speed: float
    stroke: float
    time: list[float]
    angle: list[float]
    series: list[tuple[str, str, str, str, list[float]]]
    warnings: list[str]

class _Heat(TypedDict):
    segment: int
    speed: float
    temperatures: list[float]
    joints: list[tuple[str, str, str, list[str], list[float]]]
    conductances: list[tuple[str, str, str, float, float]]
    films: list[tuple[str, str, float, float, float, float, float, bool]]
    warnings: list[str]

def check(case: Case, size: float) -> list[Finding]: ...

class FieldPress:
    def __init__(self, case: Case, size: float) -> None: ...
    def take(self, case: Case) -> None: ...
    def mesh(self, receiver: Receiver | None) -> _Mesh: ...
    def loads(self, segment: int, receiver: Receiver | None) -> _Loads: ...
    def heat(self, segment: int, receiver: Receiver | None) -> _Heat: ...
    def run(
        self,
        folder: str | pathlib.Path,
        replace: bool,
        start_from: str | pathlib.Path | None,
        receiver: Receiver | None,
    ) -> Run: ...
