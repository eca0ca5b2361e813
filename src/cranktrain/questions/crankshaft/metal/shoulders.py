"""Shoulders of a shaft: journals cut where their section changes, by what gives nothing of its own."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.metal.sections import Section
from cranktrain.questions.crankshaft.metal.shaft import Pieces, Webs


class Shoulders(NamedTuple):
    """Where journals change their section, one journal after another, along each as they stand.

    Attributes
    ----------
    piece : array of int, shape (shoulder,)
        Which piece of the shaft without shoulders each is on.
    z : Array, shape (design, shoulder)
        From where on. [m]
    section : Section, shape (design, shoulder)
    """

    piece: NDArray[np.intp]
    z: Array
    section: Section


class Shouldered(NamedTuple):
    """A shaft cut at its shoulders; first: where each piece of the shaft without them begins, shape (piece + 1,)."""

    pieces: Pieces
    webs: Webs
    first: NDArray[np.intp]


def with_shoulders(pieces: Pieces, webs: Webs, shoulders: Shoulders) -> Shouldered:
    """Cut pieces at shoulders, each a web of no length from one to the next.

    Parameters
    ----------
    pieces : Pieces
    webs : Webs
    shoulders : Shoulders

    Returns
    -------
    Shouldered

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.16) and (24.21) in each part.
    """
    n = pieces.radius.shape[1]
    whose = np.concatenate([np.arange(n, dtype=np.intp), shoulders.piece])
    order = np.argsort(whose, kind="stable")
    own = whose[order]

    def merged(of_pieces: Array, of_shoulders: Array) -> Array:
        return np.concatenate([of_pieces, np.broadcast_to(of_shoulders, shoulders.z.shape)], axis=1)[:, order]

    begins = merged(pieces.bounds[:, :-1], shoulders.z)
    sections = zip(pieces[3:], shoulders.section, strict=True)
    cut = Pieces(
        np.concatenate([begins, pieces.bounds[:, -1:]], axis=1),
        merged(pieces.radius, np.zeros(())),
        merged(pieces.angle, np.zeros(())),
        *(merged(of_pieces, of_shoulders) for of_pieces, of_shoulders in sections),
    )
    leads_on = np.where(own[:-1] == own[1:], n - 1, own[:-1])
    *of_webs, rigid = webs
    one, none = np.ones((len(begins), 1)), np.zeros((len(begins), 1, 2))
    whole = [np.concatenate([values, one], axis=1)[:, leads_on] for values in of_webs]
    joined = Webs(*whole, rigid=np.concatenate([rigid, none], axis=1)[:, leads_on])
    return Shouldered(cut, joined, np.searchsorted(own, np.arange(n + 1, dtype=np.intp)))
