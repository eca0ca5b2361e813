"""What the answer says of a diagram's curve: the largest sample beside its crest, and where it jumps."""

from collections.abc import Iterator

import numpy as np

from cranktrain.fluids.indicator.curve import CubicCurve, crest
from cranktrain.fluids.indicator.cycle import Samples
from cranktrain.language import _
from cranktrain.motion import single
from cranktrain.numerics import around_zero
from cranktrain.quantities import shown


def curve_findings(curve: CubicCurve, samples: Samples, highest: int, dead_centre: float) -> Iterator[str]:
    """Say what the samples show and what the curve makes of them.

    Parameters
    ----------
    curve : CubicCurve
    samples : Samples
        What the curve was laid through, before it was smoothed.
    highest : int
        Which of them is the file's largest pressure.
    dead_centre : float
        Where the true dead centre at firing is, in the samples' count. [rad]

    Yields
    ------
    str
    """
    crest_at, crest_pressure = crest(curve)
    sentence = _(
        "The largest sample is {sample} bar at {sample_at} from firing, the curve's crest {crest} bar at {crest_at}."
    )
    yield sentence.format(
        sample=_bar(float(samples.pressures[highest])),
        sample_at=_from_firing(float(samples.angles[highest]) - dead_centre, curve.period),
        crest=_bar(crest_pressure),
        crest_at=_from_firing(crest_at - dead_centre, curve.period),
    )
    befores = np.roll(curve.ends, 1)
    jumps = [
        _("at {angle} from {before} to {after} bar").format(
            angle=_from_firing(place - dead_centre, curve.period), before=_bar(before), after=_bar(after)
        )
        for place, before, after in zip(curve.places.tolist(), befores.tolist(), curve.starts.tolist(), strict=True)
        if before != after
    ]
    if jumps:
        yield _("The pressure jumps where the file gives two, from firing: {jumps}.").format(jumps=", ".join(jumps))


def _bar(pressure: float) -> str:
    """Write a pressure in bar."""
    return f"{shown(pressure, 'bar'):.4g}" if pressure < 1e6 else f"{shown(pressure, 'bar'):.2f}"


def _from_firing(angle: float, cycle: float) -> str:
    """Write an angle in degrees from firing, half a cycle before it to half a cycle after; no −0."""
    return f"{shown(float(around_zero(single(angle), cycle)), 'deg') + 0.0:.2f}°"
