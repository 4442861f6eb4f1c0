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
        frame = trace.tb_frame
        # The last frame outside of the library belongs to the script.
        if frame.f_globals.get("__name__", "").split(".")[0] != __name__.split(".")[0]:
            file, number = frame.f_code.co_filename, trace.tb_lineno
            code = linecache.getline(file, number).strip()
            line = f"{os.path.basename(file)}, line {number}: {code}".rstrip(": ") + "\n"
        trace = trace.tb_next
    return f"{line}{error.what}. {error.hint}\n"


def explain_uncaught() -> None:
    """Replaces the traceback of an uncaught RobotError, except with `python3 -X dev`."""
    previous = sys.excepthook

    def hook(
        kind: Type[BaseException], error: BaseException, trace: Optional[TracebackType]
    ) -> None:
        if not isinstance(error, RobotError) or sys.flags.dev_mode or sys.stderr is None:
            previous(kind, error, trace)
            return
        sys.stderr.write(explain(error, trace))

    sys.excepthook = hook
