"""What `run` says of the textbook's forms, in one line."""

from collections.abc import Mapping, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.grouping import grouped, places_of_equal
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.one_line import one_line
from cranktrain.saying.wording import ranged
from cranktrain.texts.comparison import TextbookMotion
from cranktrain.texts.percents import percent

_USUAL = ("two_harmonics", "reconstructed")
"""Methods that textbooks use most: of a plain crank, and of a slave."""
_FEW = 2
"""Of different errors that are each named with their pistons."""


def textbook_line(result: Result, file: str, design: int = 0) -> str | None:
    """Say how far the textbook's forms are off, and which command shows it.

    Parameters
    ----------
    result : Result
    file : str
        The machine file or example, as typed.
    design : int
        Which of the result's machines.

    Returns
    -------
    str or None
        Of every piston the largest of its errors of displacement, of the stroke, and of velocity and acceleration, of
        their peaks. None where no textbook's form is for the machine, or where the result was not asked for any.
    """
    motion = result.get(TextbookMotion)
    if motion is None:
        return None
    names = result.labels["piston"]
    rows = [result.labels["motion_method"].index(method) for method in _USUAL]
    every = np.stack(
        [
            one.value[design, rows]
            for one in (motion.displacement_error, motion.velocity_error, motion.acceleration_error)
        ]
    )
    known = np.flatnonzero(~np.all(np.isnan(every), axis=(0, 1))).tolist()
    if not known:
        return None
    return _(
        "Textbook forms are off by up to {errors}: {command}",
        errors=_by_piston(names, known, np.nanmax(every[..., known], axis=(0, 1))),
        command=f"cranktrain textbook {one_line(file)}",
    )


def _by_piston(names: Sequence[str], known: Sequence[int], errors: Array) -> str:
    """Write errors with their pistons, few ones of many banks by the banks; many as a range."""
    written: Mapping[str, list[int]] = {
        text: [known[i] for i in members] for text, members in places_of_equal(map(percent, errors.tolist())).items()
    }
    if len(written) == 1:
        return f"{next(iter(written))} %"
    if len(written) > _FEW:
        return _("{least} to {most} %", least=percent(float(np.min(errors))), most=percent(float(np.max(errors))))
    return ", ".join(f"{text} % ({_whose(names, members)})" for text, members in written.items())


def _whose(names: Sequence[str], members: Sequence[int]) -> str:
    """Name pistons by their banks where they are all of these, else one by one."""
    banks = grouped((name.lstrip("0123456789"), place) for place, name in enumerate(names))
    whole = [bank for bank, places in banks.items() if set(places) <= set(members)]
    if all(whole) and sum(len(banks[bank]) for bank in whole) == len(members):
        return ", ".join(whole)
    return ranged(names, members)
