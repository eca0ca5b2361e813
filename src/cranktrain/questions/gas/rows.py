"""What gas says in the answer: pressures, powers, heat, what compressors take in, what driven machines take."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.gas.flows import CompressorCapacity, CompressorFlow
from cranktrain.questions.gas.heat import HeatBalance
from cranktrain.questions.gas.powers import BrakePowers, IndicatedPowers
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.saying.rows import Amount, AnswerLine, Piece, alike, valued
from cranktrain.saying.wording import Names

_AT_DEAD_CENTRE = np.radians(0.005)
"""A peak so near the dead centre is shown as at it. [rad]"""


def pressure_rows(
    labels: Names,
    design: int,
    pressures: GasPressures,
    lines: CompressorCapacity | None,
    powers: IndicatedPowers | None,
) -> Iterator[AnswerLine]:
    """Largest pressure, unless a compressor's line has it, and the mean indicated one, unless the power has it."""
    chambers = labels["chamber"]
    peak = pressures.peak_pressure.value[design]
    if lines is None or np.any(np.isnan(lines.discharge_line_pressure[design])):
        words, pieces = _after(pressures.peak_pressure_after[design])
        yield valued(_("peak pressure"), peak, "Pa", chambers, words, **pieces)
    mean = pressures.indicated_mean_pressure[design]
    if powers is None or alike(mean, "Pa") is None:
        is_driven = np.sum(pressures.indicated_work[design]) < 0
        yield valued(_("mean indicated pressure"), -mean if is_driven else mean, "Pa", chambers)


def _after(after: np.ndarray) -> tuple[str, dict[str, Piece]]:
    """Words for where pressures are largest, if it is at the same angle in all chambers."""
    angle = alike(after, "rad")
    if np.all(np.abs(after) < _AT_DEAD_CENTRE):
        return _(", at the dead centre"), {}
    if angle is None:
        return "", {}
    return (
        (_(", {angle} after the dead centre"), {"angle": angle})
        if angle.value > 0
        else (_(", {angle} before the dead centre"), {"angle": Amount(-angle.value, "rad")})
    )


def compressor_rows(
    labels: Names, design: int, lines: CompressorCapacity, flow: CompressorFlow | None
) -> Iterator[AnswerLine]:
    """Between which pressures a compressor works, what it takes in and what flows."""
    chambers = labels["chamber"]
    suction = alike(lines.suction_line_pressure[design], "Pa")
    discharge = lines.discharge_line_pressure[design]
    if suction is None:
        yield valued(_("suction pressure"), lines.suction_line_pressure[design], "Pa", chambers)
        yield valued(_("discharge pressure"), discharge, "Pa", chambers)
    else:
        yield valued(_("discharge pressure"), discharge, "Pa", chambers, _(", suction {suction}"), suction=suction)
    part = lines.volumetric_efficiency[design]
    yield valued(_("takes in"), part, "%", chambers, _("of the swept volume"))
    if flow is not None:
        yield valued(_("flow at the inlet"), flow.inlet_flow[design], "m^3/s", chambers)


def power_rows(
    labels: Names, design: int, indicated: IndicatedPowers, pressures: GasPressures, brake: BrakePowers | None
) -> Iterator[AnswerLine]:
    """Indicated power, by bank where there are several, with its mean pressure; and what the shaft gives or takes."""
    total = float(indicated.indicated_power[design])
    sense = -1.0 if total < 0 else 1.0
    name = _("indicated power taken") if total < 0 else _("indicated power")
    banks = labels["bank"]
    pressure = Amount(sense * float(indicated.mean_indicated_pressure[design]), "Pa")
    is_one = alike(pressures.indicated_mean_pressure[design], "Pa") is not None
    if len(banks) > 1 and alike(indicated.bank_indicated_power[design], "W") is None:
        yield valued(
            name,
            sense * indicated.bank_indicated_power[design],
            "W",
            banks,
            _(", {total} in all, {pressure}") if is_one else _(", {total} in all"),
            total=Amount(sense * total, "W"),
            pressure=pressure,
        )
    else:
        yield valued(name, sense * total, "W", (), _(", {pressure}") if is_one else "", pressure=pressure)
    if brake is not None:
        power = float(brake.brake_power[design])
        yield valued(
            _("driven with") if power < 0 else _("brake power"),
            abs(power),
            "W",
            (),
            _(", {torque}, {pressure}"),
            torque=Amount(abs(float(brake.brake_torque[design])), "N*m"),
            pressure=Amount(abs(float(brake.mean_brake_pressure[design])), "Pa"),
        )


def heat_rows(labels: Names, design: int, heat: HeatBalance) -> Iterator[AnswerLine]:
    """Heat that comes in, what becomes of it."""
    loss, part = alike(heat.wall_loss[design], "J"), alike(heat.working_turn_efficiency[design], "%")
    said = _("a cycle: {part} work, {loss} to the walls")
    words, pieces = ("", dict[str, Piece]()) if loss is None or part is None else (said, {"part": part, "loss": loss})
    yield valued(_("heat"), heat.released_heat[design], "J", labels["chamber"], words, **pieces)
