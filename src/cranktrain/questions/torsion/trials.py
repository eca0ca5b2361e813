"""Holzer's table at frequencies of the file's own: amplitudes, torques, and what is left over."""

import numpy as np

from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.questions.torsion.modes import TorsionalTrain
from cranktrain.questions.torsion.parts import DeclaredTrain
from cranktrain.questions.torsion.train import holzer_amplitudes, holzer_table, scaled, shafts_apart
from cranktrain.record import record
from cranktrain.references import THEORY_OF_TORSION as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked

_DISC = ("trial", "disc")
_LIMIT = 1e-12


@record
class HolzerTrials(Checked):
    """Holzer's table at frequencies that the file names, for 1 rad at the free end, or where that is a node, elsewhere.

    What is left over is the torque that must be taken off the last disc for the train to vibrate so.
    """

    trial_frequency: Array = quantity(
        "ω", "rad/s", ("trial",), N_("Frequency at which Holzer's table is asked for"), _THEORY, "23.22", shown="Hz"
    )
    trial_residual: Array = quantity(
        "ΣJω²a", "N*m/rad", ("trial",), N_("Torque that Holzer's table leaves over there"), _THEORY, "23.22"
    )
    trial_amplitude: Array = quantity(
        "a", "1", _DISC, N_("Amplitude of the disc there, referred to the crank; 1 at the free end"), _THEORY, "23.7"
    )
    trial_torque: Array = quantity("Jω²a", "N*m/rad", _DISC, N_("Torque of the disc's inertia there"), _THEORY, "23.6")
    trial_sum: Array = quantity(
        "ΣJω²a", "N*m/rad", _DISC, N_("Torque there in the shaft that leads on from the disc"), _THEORY, "23.6"
    )
    trial_twist: Array = quantity(
        "Δa", "1", _DISC, N_("Twist there of the shaft that leads on, taken off the amplitude"), _THEORY, "23.7"
    )


def are_tried(declared: DeclaredTrain) -> bool:
    """Whether the file names frequencies."""
    return declared.tried.shape[-1] > 0


def holzer_trials(declared: DeclaredTrain, discs: TorsionalTrain) -> HolzerTrials:
    """Go through Holzer's table at each frequency; docs/theory/torsion, eqs. (23.6), (23.7) and (23.22)."""
    train, speed = discs.train, declared.tried
    known = np.all(np.isfinite(train.inertia), axis=-1) & np.all(np.isfinite(train.stiffness), axis=-1)
    shape = holzer_amplitudes(train, speed)
    # A chain that begins at the free end has amplitude 1 there, however little that is beside those of others.
    if declared.free_end > 0 or np.any(np.diff(train.following) != 1):
        with np.errstate(invalid="ignore"):
            shape, _unit = scaled(shape, declared.free_end)
    table = holzer_table(train, speed, shape)
    return HolzerTrials(
        trial_frequency=speed,
        trial_residual=table.total[..., -1],
        trial_amplitude=shape,
        trial_torque=table.torque,
        trial_sum=table.total,
        trial_twist=table.twist,
        labels={"trial": tuple(str(n + 1) for n in range(speed.shape[-1]))},
        checks=(
            Check(
                "holzer_trials",
                _("Twist of shafts against the torques that they carry in Holzer's table at the frequencies asked for"),
                np.where(known, np.max(shafts_apart(train, table, shape), axis=(-2, -1)), np.nan),
                _LIMIT,
                (_("needs every inertia and every stiffness"),) * len(known),
            ),
        ),
    )
