"""Progress of a run: a bar of tqdm where it is installed, else plain lines."""
from __future__ import annotations

import sys
from typing import Any, Protocol


class Receiver(Protocol):
    """What a run tells its caller. Any object with these methods can be given as ``progress``."""

    def stage(self, name: str) -> None:
        """A stage begins: ``mesh``, ``time steps``."""

    def progress(self, fraction: float, detail: str) -> None:
        """Progress of the stage, 0 to 1, with a few words."""

    def warn(self, text: str) -> None:
        """Something that must be known to judge the result; it is in ``result.warnings`` too."""


class Bar:
    """A bar for each stage, with tqdm."""

    def __init__(self, tqdm: Any) -> None:
        self._tqdm = tqdm
        self._bar: Any = None

    def stage(self, name: str) -> None:
        self.close()
        self._bar = self._tqdm(total=1.0, desc=name, bar_format="{desc}: {percentage:3.0f}% |{bar}| {postfix} {remaining}")

    def progress(self, fraction: float, detail: str) -> None:
        if self._bar is None:
            return
        self._bar.set_postfix_str(detail, refresh=False)
        self._bar.update(fraction - self._bar.n)

    def warn(self, text: str) -> None:
        self._tqdm.write(f"warning: {text}", file=sys.stderr)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
            self._bar = None


class Lines:
    """A line for each stage and each tenth of it."""

    def __init__(self) -> None:
        self._stage = ""
        self._tenth = 0

    def stage(self, name: str) -> None:
        self._stage, self._tenth = name, 0
        print(name, file=sys.stderr)

    def progress(self, fraction: float, detail: str) -> None:
        if int(10 * fraction) > self._tenth:
            self._tenth = int(10 * fraction)
            print(f"{self._stage}: {10 * self._tenth} % {detail}", file=sys.stderr)

    def warn(self, text: str) -> None:
        print(f"warning: {text}", file=sys.stderr)


def receiver_of(progress: bool | Receiver) -> Receiver | None:
    """The receiver of messages for an argument ``progress``. For deadpoint itself."""
    if not isinstance(progress, bool):
        return progress
    if not progress:
        return None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return Lines()
    return Bar(tqdm)


def close(receiver: Receiver | None) -> None:
    """Ends a bar. For deadpoint itself."""
    if isinstance(receiver, Bar):
        receiver.close()
