"""A shaft of throws, each of web, pin and web between two journals, as pieces joined by webs."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.metal.sections import Section, WebSection
from cranktrain.questions.crankshaft.metal.shaft import Pieces, Webs
from cranktrain.record import record


class ThrowGeometry(NamedTuple):
    """Throws of a shaft, one for each pin.

    Attributes
    ----------
    ends : Array, shape (design, 2)
        z of both ends of the shaft. [m]
    planes : Array, shape (design, throw, 2)
        z of the middle of both webs of each throw; of a web from pin to pin it is the last of one and the first of the
        next throw. [m]
    radius : Array, shape (design, throw)
        [m]
    angle : Array, shape (design, throw)
        Direction in axes that turn with the shaft, from X toward Y. [rad]
    journals : array of bool, shape (throw + 1,), optional
        Which places before, between and after the throws have a journal: without one a pin at an end hangs over, and
        one web leads from pin to pin; all have one unless said.
    """

    ends: Array
    planes: Array
    radius: Array
    angle: Array
    journals: NDArray[np.bool_] | None = None

    @property
    def pieces(self) -> NDArray[np.intp]:
        """Which of journal, pin, journal, …, counted from 0, there are."""
        every = np.arange(2 * self.radius.shape[1] + 1, dtype=np.intp)
        return every if self.journals is None else every[(every % 2 == 1) | self.journals[every // 2]]

    @property
    def webs(self) -> NDArray[np.intp]:
        """Which of all webs, two to a throw, there are: none beyond a pin that hangs over, from pin to pin one."""
        every = np.arange(2 * self.radius.shape[1], dtype=np.intp)
        if self.journals is None:
            return every
        leads_on = (every % 2 == 1) & (every < every[-1])
        return every[self.journals[(every + 1) // 2] | leads_on]


@record
class WebRule:
    """How much of a web does not give, as it is within journal and pin.

    Attributes
    ----------
    name : str
    share : float
        Of the journal's diameter at one end, of the pin's at the other.
    source : str
        Who says so; not yet translated.
    """

    name: str
    share: float
    source: str


WEB_RULES = (
    WebRule("whole", 0.0, N_("from axis to axis")),
    WebRule("ker_wilson", 0.2, N_("r − 0.2 (d_j + d_p), Ker Wilson's rule for torsion")),
)
"""Rules for the length of a web, that of plain centre lines first."""


def pieces_of_throws(throws: ThrowGeometry, journals: Section, pins: Section) -> Pieces:
    """Journal, pin, journal, … as far as there are journals: `throws.pieces` says which each piece is.

    Parameters
    ----------
    throws : ThrowGeometry
    journals : Section, shape (design, throw + 1)
    pins : Section, shape (design, throw)

    Returns
    -------
    Pieces
    """
    n_designs, n_throws = throws.radius.shape
    planes = throws.planes.reshape(n_designs, 2 * n_throws)[:, throws.webs]
    bounds = np.concatenate([throws.ends[:, :1], planes, throws.ends[:, 1:]], axis=1)
    none = np.zeros((n_designs, n_throws + 1))
    pairs = ((none, throws.radius), (none, throws.angle), *zip(journals, pins, strict=True))
    return Pieces(bounds, *(in_turn(journal, pin)[:, throws.pieces] for journal, pin in pairs))


def webs_of_throws(
    throws: ThrowGeometry,
    sections: WebSection,
    journal_diameter: Array,
    pin_diameter: Array,
    rule: WebRule,
    journal_end: Array | None = None,
) -> Webs:
    """Webs of throws, as far as they are there: `throws.webs` says which each is.

    Parameters
    ----------
    throws : ThrowGeometry
    sections : WebSection, shape (design, throw, 2)
        From pin to pin, the last of the first throw's.
    journal_diameter : Array, shape (design, throw + 1)
        [m]
    pin_diameter : Array, shape (design, throw)
        [m]
    rule : WebRule
    journal_end : Array, shape (design, throw + 1), optional
        Diameter of journals at their ends, where shoulders make it another. [m]

    Returns
    -------
    Webs
    """
    shape = (len(pin_diameter), -1)
    ends = (journal_diameter if journal_end is None else journal_end, journal_diameter)
    before, behind = (rule.share * in_turn(journal, pin_diameter)[:, throws.pieces] for journal in ends)
    rigid = np.stack([before[:, :-1], behind[:, 1:]], axis=-1)
    return Webs(*(np.reshape(values, shape)[:, throws.webs] for values in sections), rigid=rigid)


def in_turn(journals: Array, pins: Array) -> Array:
    """Put values of journals and pins in turn, shape (design, 2·throw + 1)."""
    found = np.empty((journals.shape[0], journals.shape[1] + pins.shape[1]))
    found[:, 0::2], found[:, 1::2] = journals, pins
    return found
