"""Hammer blow: with what the wheels of a locomotive's driving axle press the rail and let it go once a turn."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.frames import Frames
from cranktrain.layout.shafts import AxialPlaces, Throws
from cranktrain.layout.specs import MAIN
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.balance.counterweights import two_plane_vectors
from cranktrain.questions.balance.frame_forces import FrameForces
from cranktrain.questions.balance.rotating_weights import weight_vectors
from cranktrain.questions.balance.weights import BalanceWeights, DeclaredBalance, divided
from cranktrain.record import record
from cranktrain.references import THEORY_OF_BALANCE as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_WHEEL = ("wheel",)
_NOTHING = 1e-12
"""Of what all that turns would do together: less is rounding."""


@record
class HammerBlow(StageResult):
    """What turns out of balance on the axle, as both wheels bear it."""

    hammer_blow: Array = quantity(
        "F_H",
        "N",
        _WHEEL,
        N_("Hammer blow: by how much a wheel presses the rail more, and half a turn later less, than at rest"),
        _THEORY,
        "16.19",
        worst="largest",
    )
    hammer_blow_at: Array = quantity(
        "φ(F_H)",
        "deg",
        _WHEEL,
        N_("Crank angle at which a wheel presses the rail most"),
        _THEORY,
        "16.19",
        is_place=True,
    )
    hammer_blow_share: Array = quantity(
        "F_H/G_W", "1", _WHEEL, N_("Hammer blow in parts of the load of the wheel at rest"), _THEORY, "16.19"
    )
    lifting_speed: Array = quantity(
        "ω_H", "rad/s", _WHEEL, N_("Speed at which the hammer blow lifts the wheel"), _THEORY, "16.20", shown="rpm"
    )


def have_wheels(declared: DeclaredBalance) -> bool:
    """Whether the file has wheels."""
    return declared.wheels is not None


def hammer_blow(
    frame: FrameForces,
    frames: Frames,
    throws: Throws,
    axial: AxialPlaces,
    declared: DeclaredBalance,
    weights: BalanceWeights,
    speed: Speed,
) -> HammerBlow:
    """Put all that rotates on `main`, weights too, to the planes of the wheels; docs/theory/balance, eq. (16.19)."""
    wheels = declared.wheels
    assert wheels is not None  # else the stage does not apply
    own = np.array([throws.shafts[throw] == MAIN for throw in map(int, throws.carrying)])
    rotating, _swinging = divided(frame, frames)
    of_weights = weight_vectors(weights.weights, np.ones(1)).forward[..., 0]
    vectors = np.concatenate([rotating[..., 0] * own, of_weights], axis=-1)
    place = np.concatenate([axial.throw, weights.weights.position], axis=-1)
    force, couple = np.sum(vectors, axis=-1), np.sum(place * vectors, axis=-1)
    # Weights in the wheels that took all of it away would be just opposite.
    at_wheels = -two_plane_vectors(force, couple, wheels.place)
    together = np.sum(np.abs(vectors), axis=-1, keepdims=True)
    moment = np.where(np.abs(at_wheels) > _NOTHING * together, np.abs(at_wheels), 0.0)
    blow = moment * speed.mean[:, 0] ** 2
    lifts = np.where(moment > 0, moment, np.nan)
    return HammerBlow(
        hammer_blow=blow,
        hammer_blow_at=np.where(moment > 0, np.mod(np.pi - np.angle(at_wheels), TURN), np.nan),
        hammer_blow_share=blow / wheels.load,
        lifting_speed=np.sqrt(wheels.load / lifts),
        labels={"wheel": wheels.names},
    )
