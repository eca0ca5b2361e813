"""The terminal: it parses what is typed, hands it to the library, and renders what comes back."""

import gc
import os
import sys
import traceback
from collections.abc import Sequence

from cranktrain.errors import InputError
from cranktrain.language import _

__all__ = ["main"]

_BAD_INPUT, _BUG, _STOPPED, _NOBODY_READS = 2, 70, 130, 141


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the terminal.

    Parameters
    ----------
    arguments : sequence of str, optional
        What was typed after the program's name; taken from the command line unless given.

    Returns
    -------
    int
        Exit status: 0 good, 2 bad input, 70 a bug of cranktrain, 130 stopped by Ctrl-C, 141 if nobody reads the output.
    """
    if arguments is None:
        gc.disable()  # a program so short leaves no garbage, and looking for it takes a sixth of its time
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # for systems of a few unknowns more threads only wait
    try:
        _tolerate_narrow_encodings()
        from cranktrain.cli.app import task  # inside, so that Ctrl-C is answered from the start

        task(sys.argv[1:] if arguments is None else arguments)()
        sys.stdout.flush()
    except InputError as error:
        return _said(str(error), _BAD_INPUT)
    except KeyboardInterrupt:
        return _said(_("stopped"), _STOPPED)
    except BrokenPipeError:
        _discard_output()
        return _NOBODY_READS
    except MemoryError:
        return _said(_("the memory of this computer does not suffice; a coarser --step needs less"), _BAD_INPUT)
    except OSError as error:
        _discard_output()
        return _said(
            _("standard output  cannot be written: {reason}").format(reason=error.strerror or error), _BAD_INPUT
        )
    except Exception:  # whatever is left is a bug, and no traceback ever reaches a user
        if os.environ.get("CRANKTRAIN_TRACEBACK") == "1":
            traceback.print_exc()
        return _said(_bug_report(sys.argv[1:] if arguments is None else arguments), _BUG)
    finally:
        if arguments is None:
            gc.freeze()  # nor does Python look through it all once more at its end
    return 0


def _said(message: str, status: int) -> int:
    """Say on stderr what ended the program."""
    print(message, file=sys.stderr)
    return status


def _bug_report(arguments: Sequence[str]) -> str:
    """Ask for a report of an error that is none of the user's."""
    import shlex

    return _(
        "This is a bug of cranktrain. Please report it with the machine file and this command: {command}\n"
        "(CRANKTRAIN_TRACEBACK=1 shows where it happened.)"
    ).format(command=shlex.join(["cranktrain", *arguments]))


def _tolerate_narrow_encodings() -> None:
    """Let a terminal whose encoding lacks φ show something else instead of failing."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="backslashreplace")


def _discard_output() -> None:
    """Send what is still buffered nowhere, so that Python does not complain about it at its end."""
    if sys.stdout is sys.__stdout__:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
