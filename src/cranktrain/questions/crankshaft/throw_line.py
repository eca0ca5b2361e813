"""A shaft of throws, each of web, pin and web between two journals, as pieces joined by webs."""

from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.sections import Section, WebSection
from cranktrain.questions.crankshaft.shaft import Pieces, Webs
from cranktrain.record import record


class ThrowGeometry(NamedTuple):
    """Throws of a shaft.

    Attributes
    ----------
    ends : Array, shape (design, 2)
        z of both ends of the shaft. [m]
    planes : Array, shape (design, throw, 2)
        z of the middle of both webs of each throw. [m]
    radius : Array, shape (design, throw)
        [m]
    angle : Array, shape (design, throw)
        Direction in axes that turn with the shaft, from X toward Y. [rad]
    """

    ends: Array
    planes: Array
    radius: Array
    angle: Array


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
    """Journal, pin, journal, …: pieces 0, 2, … are journals, piece 2i + 1 is the pin of throw i.

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
    planes = throws.planes.reshape(n_designs, 2 * n_throws)
    bounds = np.concatenate([throws.ends[:, :1], planes, throws.ends[:, 1:]], axis=1)
    none = np.zeros((n_designs, n_throws + 1))
    sections = (in_turn(journal, pin) for journal, pin in zip(journals, pins, strict=True))
    return Pieces(bounds, in_turn(none, throws.radius), in_turn(none, throws.angle), *sections)


def webs_of_throws(sections: WebSection, journal_diameter: Array, pin_diameter: Array, rule: WebRule) -> Webs:
    """Webs of throws: 2i and 2i + 1 are those of throw i.

    Parameters
    ----------
    sections : WebSection, shape (design, throw, 2)
    journal_diameter : Array, shape (design, throw + 1)
        [m]
    pin_diameter : Array, shape (design, throw)
        [m]
    rule : WebRule

    Returns
    -------
    Webs
    """
    n_designs, n_throws = pin_diameter.shape
    shape = (n_designs, 2 * n_throws)
    journal = rule.share * np.stack([journal_diameter[:, :-1], journal_diameter[:, 1:]], axis=-1)
    pin = rule.share * np.stack([pin_diameter, pin_diameter], axis=-1)
    first, last = journal.copy(), pin.copy()
    first[..., 1], last[..., 1] = pin[..., 1], journal[..., 1]
    rigid = np.stack([first.reshape(shape), last.reshape(shape)], axis=-1)
    return Webs(*(np.reshape(values, shape) for values in sections), rigid=rigid)


def in_turn(journals: Array, pins: Array) -> Array:
    """Put values of journals and pins in the order of pieces, shape (design, 2·throw + 1)."""
    found = np.empty((journals.shape[0], journals.shape[1] + pins.shape[1]))
    found[:, 0::2], found[:, 1::2] = journals, pins
    return found
