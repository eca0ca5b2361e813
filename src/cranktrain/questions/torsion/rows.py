"""What torsion says in the answer: natural frequencies, critical speeds beside the machine's, the worst orders."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import Listed, _
from cranktrain.questions.torsion.critical import CriticalSpeeds
from cranktrain.questions.torsion.modes import TorsionalModes
from cranktrain.questions.torsion.throw_stiffness import ThrowStiffness, title_of
from cranktrain.questions.torsion.trials import HolzerTrials
from cranktrain.saying.amounts import Extent
from cranktrain.saying.rows import AnswerLine, Telling, worded

_NAMED = 3


def frequency_rows(of: Telling, modes: TorsionalModes) -> Iterator[AnswerLine]:
    """The lowest natural frequencies."""
    n_modes = modes.natural_frequency.shape[1]
    lowest = [of.amount(modes, "natural_frequency", mode) for mode in range(min(n_modes, _NAMED))]
    if not all(np.isfinite(one.value) for one in lowest):
        return
    more, first = n_modes - len(lowest), Listed(lowest)
    yield worded(_("natural frequencies"), _("{first} and {n} more", first=first, n=more) if more else first)


def critical_rows(of: Telling, found: CriticalSpeeds) -> Iterator[AnswerLine]:
    """The critical speeds of the first mode on both sides of the machine's, of orders that excite it much."""
    speeds = [of.amount(found, "critical_speed", 0, place) for place in found.beside(of.design)]
    said = [_("{speed} (order {order})", speed=one, order=one.member[-1]) for one in speeds]
    if said:
        yield worded(_("next critical speeds"), Listed(said))


def trial_rows(of: Telling, found: HolzerTrials) -> Iterator[AnswerLine]:
    """What Holzer's table leaves over at frequencies of the file's own, for 1 rad at the free end."""
    for trial in range(min(found.trial_frequency.shape[1], _NAMED)):
        frequency, left = (of.amount(found, name, trial) for name in ("trial_frequency", "trial_residual"))
        if np.isfinite(left.value):
            yield worded(_("left over at {frequency}", frequency=frequency), _("{torque}, Holzer", torque=left))


def stiffness_rows(of: Telling, found: ThrowStiffness) -> Iterator[AnswerLine]:
    """The softest stiffness from throw to throw, and how far off it other methods are."""
    gap = found.softest(of.design)
    if gap is None:
        return
    own = of.amount(found, "throw_stiffness", found.chosen, gap)
    others = np.delete(of.values(found, "throw_stiffness")[:, gap], found.chosen) / own.value - 1
    extent = Extent(float(np.nanmin(others)), float(np.nanmax(others)), "off", quantity="throw_stiffness")
    method = title_of(of.labels["throw_method"][found.chosen])
    words = _("{stiffness}, {method}; others {range}", stiffness=own, method=method, range=extent)
    yield worded(_("stiffness of throws"), words)
