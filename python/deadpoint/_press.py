"""A press: a case file with changes."""
from __future__ import annotations

import pathlib
import tempfile
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from deadpoint import _reduced
from deadpoint._errors import Finding, InputError, Interrupted, path_of, reading, unknown, writing
from deadpoint._loads import Heat, Loads, Mesh, heat_of, loads_of
from deadpoint._progress import Receiver, close, receiver_of

if TYPE_CHECKING:
    from deadpoint import _field
    from deadpoint._results import Result
    from deadpoint._rom import Rom

Setting = Any  # text with a unit, number, truth value, list of these, or a quantity of pint


def _text_of(value: Setting) -> str:
    """A value as the command line takes it behind --set KEY=."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return value
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(item) for item in value) + "]"
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        unit = f"{value.units:~C}".replace("°C", "degC")
        return f"{float(value.magnitude)!r} {unit}"
    return repr(value.item() if hasattr(value, "item") else value)


def _toml(value: Setting) -> str:
    text = _text_of(value)
    quoted = isinstance(value, str) or hasattr(value, "magnitude")
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"' if quoted else text


def _base_units(value: Setting) -> Setting:
    return value.to_base_units() if hasattr(value, "to_base_units") else value


class Press:
    """A press that was read from a case file. Made by :func:`deadpoint.load`.

    ``press["operation.0.speed"]`` reads a key, ``press["operation.0.speed"] = "300 rpm"`` changes it. Keys and units are
    those of the case file and of ``--set``. A wrong key, unit or value raises an error at once, and nothing is changed.
    """

    def __init__(self, file: str | pathlib.Path, settings: Mapping[str, Setting] | None = None,
                 allow_outside: bool = False) -> None:
        self.file = path_of(file)
        """The case file."""
        self._allow_outside = allow_outside
        self._settings: dict[str, str] = {key: _text_of(value) for key, value in (settings or {}).items()}
        self._case = self._read(self._settings)
        self._values: dict[str, Any] | None = None
        self._field: _field.FieldPress | None = None
        self._field_size = 0.0
        self._field_case = self._case

    def _read(self, settings: Mapping[str, str]) -> _reduced.Case:
        texts = [f"{key}={value}" for key, value in settings.items()]
        return _reduced.Case(self.file, texts, 1.0, self._allow_outside)

    # ---------------------------------------------------------------- keys

    def __getitem__(self, key: str) -> Any:
        """The value of a key: a text with its unit, a number, a list or a table."""
        if self._values is None:
            import tomllib

            with reading("case"):
                self._values = tomllib.loads(self._case.text)
        found: Any = self._values
        for step in str(key).split("."):
            found = _step(found, step, key)
        return found

    def __setitem__(self, key: str, value: Setting) -> None:
        self.update({key: value})

    def update(self, settings: Mapping[str, Setting]) -> None:
        """Changes several keys at once.

        :raises deadpoint.InputError: with every mistake; nothing is changed then
        """
        changed, case = self._changed(settings)
        self._settings, self._case, self._values = changed, case, None

    def _changed(self, settings: Mapping[str, Setting]) -> tuple[dict[str, str], _reduced.Case]:
        changed = {**self._settings, **{key: _text_of(value) for key, value in settings.items()}}
        try:
            return changed, self._read(changed)
        except InputError as mistake:
            if not any(hasattr(value, "to_base_units") for value in settings.values()):
                raise
            try:
                converted = {key: _text_of(_base_units(value)) for key, value in settings.items()}
            except Exception:  # pint cannot convert it
                raise mistake from None
            changed = {**self._settings, **converted}
            return changed, self._read(changed)

    def changed(self, settings: Mapping[str, Setting]) -> Press:
        """A copy with other values; this press stays as it is."""
        made = Press.__new__(Press)
        made.__dict__.update(self.__dict__)
        made._settings, made._case = self._changed(settings)
        made._values, made._field = None, None
        return made

    @property
    def allow_outside(self) -> bool:
        """Whether the case may name files outside its own folder."""
        return self._allow_outside

    @property
    def settings(self) -> dict[str, str]:
        """What was changed, as for ``--set``."""
        return dict(self._settings)

    # ---------------------------------------------------------------- the case

    @property
    def case(self) -> _reduced.Case:
        """The case as the extension modules take it."""
        return self._case

    @property
    def name(self) -> str:
        """The case's own name."""
        return self._case.name

    @property
    def hash(self) -> str:
        """Hash of the case, equal for equal cases in any notation; result folders and reduced models state it."""
        return self._case.hash

    @property
    def text(self) -> str:
        """The case as one TOML text: includes merged, defaults stated, with the changes."""
        return self._case.text

    @property
    def warnings(self) -> list[Finding]:
        """Warnings of reading."""
        return list(self._case.findings)

    def save(self, file: str | pathlib.Path) -> None:
        """Writes :attr:`text` to a new file.

        :raises deadpoint.InputError: if the file exists
        """
        path = path_of(file)
        with writing(path):
            try:
                with path.open("x", encoding="utf-8") as out:
                    out.write(self.text)
            except FileExistsError:
                raise InputError(f"'{path}' exists\n  help: remove it or give another name") from None

    # ---------------------------------------------------------------- with meshes and fields

    def _with_mesh(self, size: float) -> _field.FieldPress:
        from deadpoint import _field

        if self._field is None or self._field_size != size:
            self._field, self._field_size = _field.FieldPress(self._case, size), size
        elif self._field_case is not self._case:
            self._field.take(self._case)
        self._field_case = self._case
        return self._field

    def check(self, size: float = 1.0) -> list[Finding]:
        """All mistakes and warnings that ``deadpoint check`` prints; empty if there are none.

        Meshes the case and checks its loads, laws and dimension chain.

        :param size: factor on all cell sizes: 2 is coarser and faster
        """
        from deadpoint import _field

        return _field.check(self._case, size)

    def mesh(self, size: float = 1.0, progress: bool | Receiver = False) -> Mesh:
        """Meshes the parts; later calls and runs with the same size use the same mesh.

        :param size: factor on all cell sizes: 2 is coarser and faster
        """
        receiver = receiver_of(progress)
        found = self._with_mesh(size).mesh(receiver)
        close(receiver)
        return Mesh(found["cells"], found["nodes"], found["half_model"], found["parts"])

    def loads(self, segment: int = -1, size: float = 1.0) -> Loads:
        """Motion, joint forces and bearing loads over a turn of the crank.

        :param segment: of the operation, from 0; -1: the first in which the press runs
        """
        return loads_of(self._with_mesh(size).loads(segment, None))

    def heat(self, segment: int = -1, size: float = 1.0) -> Heat:
        """Friction heat, contact conductances and convection coefficients by the laws of the case, before any run.

        :param segment: of the operation, from 0; -1: the first in which the press runs
        """
        return heat_of(self._with_mesh(size).heat(segment, None))

    def run(self, folder: str | pathlib.Path | None = None, size: float = 1.0, progress: bool | Receiver = False,
            replace: bool = False, start_from: str | pathlib.Path | None = None) -> Result:
        """Computes temperatures and drift over the operation, as ``deadpoint run`` does, on one process.

        A second run with other operation, friction, oil or convection uses the mesh and the unknowns of the first.

        :param folder: where all files of ``deadpoint run`` are written; None: a folder that goes with the result
        :param size: factor on all cell sizes: 2 is coarser and faster
        :param progress: True shows a bar; or any object with the methods of :class:`deadpoint.Receiver`
        :param replace: an existing result folder may be replaced
        :param start_from: a result folder whose final temperatures are the start
        :raises deadpoint.InputError: with every mistake that the mesh, the loads and the laws show
        :raises deadpoint.Interrupted: after Ctrl-C; its ``result``, and the folder, have the run up to then
        """
        from deadpoint._results import Result, open_result

        with writing("temporary folder"):
            temporary = tempfile.TemporaryDirectory(prefix="deadpoint-") if folder is None else None
        target = pathlib.Path(temporary.name, "results") if folder is None and temporary else path_of(folder or "")
        start = None if start_from is None else path_of(start_from)
        receiver = receiver_of(progress)
        try:
            run = self._with_mesh(size).run(target, replace, start, receiver)
        finally:
            close(receiver)
        result = Result(target, run) if temporary else open_result(target)
        result.temporary = temporary
        if run.interrupted:
            raise Interrupted(result)
        return result

    def reduce(self, file: str | pathlib.Path, size: float = 1.0, full_runs: int = 2, fields: bool = False,
               certify: bool = False, resume: bool = False, replace: bool = False, progress: bool = False) -> Rom:
        """Builds a reduced model with ``deadpoint reduce`` and opens it.

        :param file: of the model: ``press.rom``
        :param size: factor on all cell sizes
        :param full_runs: full runs to compare with
        :param fields: also store the fields of the states
        :param certify: also store what bounds of errors need
        :param resume: continue a build that was stopped
        :param replace: replace a model that is there, and discard a build that was stopped
        """
        from deadpoint._command import call, case_arguments
        from deadpoint._rom import open_rom

        flags = [name for name, on in (("--fields", fields), ("--certify", certify), ("--resume", resume),
                                  ("--force", replace)) if on]
        call("reduce", [*case_arguments(self), "--size", size, "--full-runs", full_runs, "-o", file, *flags], progress)
        return open_rom(file)

    def __repr__(self) -> str:
        changes = "".join(f", {key} = {value}" for key, value in self._settings.items())
        return f"<Press '{self.name}' from '{self.file}'{changes}>"


def _step(found: Any, step: str, key: str) -> Any:
    """The item of a table or list that a step of a key names."""
    if isinstance(found, dict):
        if step not in found:
            raise unknown("key", key, [step_ for step_ in found])
        return found[step]
    if isinstance(found, list):
        if step.isdecimal() and int(step) < len(found):
            return found[int(step)]
        for item in found:
            if isinstance(item, dict) and item.get("name") == step:
                return item
        raise unknown("item", key, [str(number) for number in range(len(found))])
    raise unknown("key", key, [])


def load(file: str | pathlib.Path, settings: Mapping[str, Setting] | None = None, allow_outside: bool = False) -> Press:
    """Reads and checks a case file.

    :param file: the case (TOML)
    :param settings: changes by key: ``{"operation.0.speed": "300 rpm"}``; numbers and quantities of pint too
    :param allow_outside: the case may name files outside its own folder
    :raises deadpoint.InputError: with every mistake of the case as ``findings``
    :raises deadpoint.IoError: if the file cannot be read
    """
    return Press(file, settings, allow_outside)


def press_of(case: Press | str | pathlib.Path) -> Press:
    """A press, or that of a case file. For deadpoint itself."""
    return case if isinstance(case, Press) else load(case)
