"""`textbook --harmonics`: a piston's harmonics in closed form beside the texts' series and their two harmonics."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from cranktrain.grouping import places_of_equal
from cranktrain.language import Words, _
from cranktrain.machine import Machine
from cranktrain.motion import single
from cranktrain.saying.sections import Column, Grid, ShownSection
from cranktrain.saying.wording import ranged, signless
from cranktrain.textbook.shown.tables import EXACT
from cranktrain.textbook.speaking import speaking
from cranktrain.texts.harmonic_series import acceleration_series, torque_series, two_harmonic_torque, two_harmonics
from cranktrain.texts.plain_cranks import PLAIN

_DECIMALS = 10
_LEAST = 1e-15
"""A smaller error is rounding."""


def machine_harmonics(machine: Machine, file: str, settings: Sequence[str]) -> Iterator[ShownSection]:
    """Give the harmonics of every distinct ratio of crank radius and rod of a machine, or which texts speak of it."""
    places = [place for place in machine.places if place.kind.name in PLAIN and place.geometry.offset == 0.0]
    ratios = places_of_equal([float(place.geometry.crank_radius / place.geometry.rod_length) for place in places])
    names = [place.name for place in places]
    if ratios:
        words = _("{pistons}, λ = {ratio:.4g}")
        yield from harmonic_sections(
            {words.format(pistons=ranged(names, members), ratio=own): own for own, members in ratios.items()}
        )
        return
    none = _("Only a central slider-crank or eccentric has them in closed form.")
    others = [_("`{command}` has something for this machine", command=one) for one in speaking(machine, file, settings)]
    yield ShownSection(_("Harmonics"), (none, *others))


def harmonic_sections(ratios: Mapping[Words, float]) -> Iterator[ShownSection]:
    """Give the harmonics of acceleration and torque for some ratios, by whose they are."""
    for whose, ratio in ratios.items():
        yield from _harmonics(whose, ratio)
    explained = _(
        "α is the angle of the slider's own crank or eccentric, from the top. The series of the texts "
        "go to the seventh power of λ, of the torque to the sixth; their two harmonics are cos α + λ cos 2α, and the "
        "torque is that of these. Δ is what a form is off. Orders that are not listed are zero, but for exact ones "
        "beyond the last."
    )
    yield ShownSection(_("What they are"), (explained,))


def _harmonics(whose: Words, ratio: float) -> Iterator[ShownSection]:
    """Harmonics of acceleration and torque for one ratio, by each form with what it is off."""
    value = single(ratio)
    acceleration = _("Acceleration of {pistons}: x″ = R Σ A_k cos kα", pistons=whose)
    torque = _("Torque of inertia of {pistons}: T = m R² ω² Σ D_k sin kα", pistons=whose)
    for heading, symbol, series, two in (
        (acceleration, "A", acceleration_series(value), two_harmonics(value)),
        (torque, "D", torque_series(value), two_harmonic_torque(value)),
    ):
        orders = np.flatnonzero(series.exact)
        columns = [Column(_(EXACT), [_figure(one) for one in series.exact[orders].tolist()])]
        for head, method in ((_("series"), series), (_("two harmonics"), two)):
            columns.append(Column(head, [_figure(one) for one in method.textbook[orders].tolist()]))
            columns.append(Column("Δ", ["0" if abs(one) < _LEAST else f"{one:.1e}" for one in method.error[orders]]))
        yield ShownSection(heading, (Grid(columns, [f"{symbol}_{order}" for order in orders]),))


def _figure(value: float) -> str:
    return signless(f"{value:.{_DECIMALS}f}") if value != 0.0 else "0"
