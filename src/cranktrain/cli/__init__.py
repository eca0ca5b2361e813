"""The terminal: it parses what is typed, hands it to the library, and renders what comes back."""

import gc
import os
import signal
import sys
import traceback
from collections.abc import Sequence
from contextlib import suppress
from importlib import import_module
from types import FrameType, ModuleType

from cranktrain.errors import InputError, Position, Problem
from cranktrain.language import said as _
from cranktrain.one_line import visible

__all__ = ["main"]

_BAD_INPUT, _BUG, _STOPPED, _NOBODY_READS = 2, 70, 130, 141
_COMPLETING = "_CRANKTRAIN_COMPLETE"
"""Set by a shell that asks what may be typed."""

_SIGNALLED = 128
"""And the number of the signal that ended the program."""


_NONE = "__all__"
"""What tells pydantic that all its plugins are disabled."""


class _NoPlugins(ModuleType):
    """Stands where pydantic looks for plugins, which to find none imports forty files, a thirtieth of a small run.

    What else somebody may ask of it is asked of pydantic's own.
    """

    home = "pydantic.plugin._loader"
    get_plugins = staticmethod(tuple[object, ...])

    def __getattr__(self, name: str) -> object:
        """Make room for pydantic's own; what Python asks of every file is none of it."""
        if name.startswith("__"):
            raise AttributeError(name)
        sys.modules.pop(self.home, None)
        return getattr(import_module(self.home), name)


class _Ended(BaseException):
    """What a signal other than Ctrl-C raises, so that files half written are taken away as then."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the terminal.

    Parameters
    ----------
    arguments : sequence of str, optional
        What was typed after the program's name; taken from the command line unless given.

    Returns
    -------
    int
        Exit status: 0 good, 2 bad input, 70 a bug of cranktrain, 129 the terminal is gone, 130 stopped by Ctrl-C, 141
        nobody reads the output, 143 asked to end.
    """
    if arguments is None:
        _end_by_exception()
        gc.disable()  # a program so short leaves no garbage, and looking for it takes a sixth of its time
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # for systems of a few unknowns more threads only wait
        if os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", _NONE) == _NONE:
            sys.modules.setdefault(_NoPlugins.home, _NoPlugins(_NoPlugins.home))
    try:
        _look_at_streams()
        if _COMPLETING in os.environ and arguments is None:
            from cranktrain.cli.completing.candidates import show_candidates

            show_candidates(sys.argv[1:])
            return 0
        from cranktrain.cli.app import task  # inside, so that Ctrl-C is answered from the start

        task(sys.argv[1:] if arguments is None else arguments)()
        sys.stdout.flush()
    except InputError as error:
        return _said(str(error), _BAD_INPUT)
    except KeyboardInterrupt:
        # Python ends by the signal, in place of our status, where that came while source text ran, as classes are made
        # of it, unless other text has run to its end since.
        exec("")
        return _said(_("stopped"), _STOPPED)
    except _Ended as ended:
        _discard_output()
        return _said(_("stopped"), _SIGNALLED + ended.args[0])
    except BrokenPipeError:
        _discard_output()
        return _NOBODY_READS
    except MemoryError:
        return _said(_("the memory of this computer does not suffice; a coarser --step needs less"), _BAD_INPUT)
    except OSError as error:
        _discard_output()
        return _said(_("standard output  cannot be written: {reason}", reason=error.strerror or error), _BAD_INPUT)
    except Exception:  # whatever is left is a bug, and no traceback ever reaches a user
        if os.environ.get("CRANKTRAIN_TRACEBACK") == "1":
            traceback.print_exc()
        return _said(_bug_report(sys.argv[1:] if arguments is None else arguments), _BUG)
    finally:
        if arguments is None:
            gc.freeze()  # nor does Python look through it all once more at its end
    return 0


def _said(message: str, status: int) -> int:
    """Say on stderr what ended the program; where that is closed or full, the status has to do."""
    with suppress(OSError):
        if sys.stderr is not None:
            print(visible(message, kept="\n"), file=sys.stderr, flush=True)
    return status


def _end_by_exception() -> None:
    """Let what asks the program to end, or takes its terminal away, end it as Ctrl-C does; unless it is not to mind."""

    def end(number: int, _frame: FrameType | None) -> None:
        signal.signal(number, signal.SIG_IGN)  # once is enough: what is cleaned up meanwhile is not to be disturbed
        raise _Ended(number)

    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)  # not every system has both
        if number is not None and signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, end)


def _bug_report(arguments: Sequence[str]) -> str:
    """Ask for a report of an error that is none of the user's."""
    import shlex

    return _(
        "This is a bug of cranktrain. Please report it with the machine file and this command: {command}\n"
        "(CRANKTRAIN_TRACEBACK=1 shows where it happened.)",
        command=shlex.join(["cranktrain", *arguments]),
    )


def _look_at_streams() -> None:
    """Refuse a standard output that is closed, and let an encoding that lacks φ show something else instead of failing.

    Where standard error is closed, a file opened next would take its place, and with it what libraries say there.
    """
    if sys.stderr is None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    if sys.stdout is None:
        raise InputError([Problem("", None, _("is closed"), None, Position(_("standard output")))])
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="backslashreplace")


def _discard_output() -> None:
    """Send what is still buffered nowhere, so that Python does not complain about it at its end."""
    if sys.stdout is not None and sys.stdout is sys.__stdout__:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
