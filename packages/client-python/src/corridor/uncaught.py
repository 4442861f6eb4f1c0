"""Prints uncaught errors as the script's line and a sentence."""

from __future__ import annotations

import linecache
import os
import sys
from types import TracebackType
from typing import Optional, Type

from .errors import RobotError


def explain(error: RobotError, trace: Optional[TracebackType]) -> str:
    """The line of the script, then the cause and the hint."""
    line = ""
    while trace is not None:
        # The last frame outside of the library belongs to the script.
        if not _is_own(trace):
            line = f"{_line_of(trace)}\n"
        trace = trace.tb_next
    return f"{line}{error.what}. {error.hint}\n"


def explain_interrupt(error: BaseException) -> Optional[str]:
    """The line of the script that Ctrl+C interrupted; None if it was not a call of the library."""
    trace, line = error.__traceback__, None
    while trace is not None and trace.tb_next is not None:
        if not _is_own(trace) and _is_own(trace.tb_next):
            line = f"Stopped by Ctrl+C: {_line_of(trace)}\n"
        trace = trace.tb_next
    # asyncio raises it outside of the script, while it handles the cancellation of the script.
    if line is None and error.__context__ is not None:
        return explain_interrupt(error.__context__)
    return line


def _is_own(trace: TracebackType) -> bool:
    """Whether the frame belongs to the library."""
    name: str = trace.tb_frame.f_globals.get("__name__", "")
    return name.split(".")[0] == __name__.split(".")[0]


def _line_of(trace: TracebackType) -> str:
    file, number = trace.tb_frame.f_code.co_filename, trace.tb_lineno
    code = linecache.getline(file, number).strip()
    return f"{os.path.basename(file)}, line {number}: {code}".rstrip(": ")


def explain_uncaught() -> None:
    """Replaces the traceback of an uncaught RobotError or Ctrl+C, except with `python3 -X dev`."""
    previous = sys.excepthook

    def hook(
        kind: Type[BaseException], error: BaseException, trace: Optional[TracebackType]
    ) -> None:
        text = None
        if isinstance(error, RobotError):
            text = explain(error, trace)
        elif isinstance(error, KeyboardInterrupt):
            text = explain_interrupt(error)
        if text is None or sys.flags.dev_mode or sys.stderr is None:
            previous(kind, error, trace)
            return
        sys.stderr.write(text)

    sys.excepthook = hook
