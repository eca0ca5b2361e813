"""What gas says in the answer: pressures, powers, heat, what compressors take in, what driven machines take."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from cranktrain.language import N_, Message, _
from cranktrain.questions.gas.flows import CompressorCapacity, CompressorStages
from cranktrain.questions.gas.heat import HeatBalance
from cranktrain.questions.gas.powers import BrakePowers, IndicatedPowers
from cranktrain.questions.gas.pressures import GasPressures, PeakPressures
from cranktrain.saying.rows import AnswerLine, Telling

_AT_DEAD_CENTRE = np.radians(0.005)
"""A peak so near the dead centre is shown as at it. [rad]"""


def pressure_rows(
    of: Telling,
    pressures: GasPressures,
    peaks: PeakPressures | None,
    lines: CompressorCapacity | None,
    powers: IndicatedPowers | None,
) -> Iterator[AnswerLine]:
    """Largest pressure, unless a compressor's line has it, and the mean indicated one, unless the power has it."""
    has_line = lines is not None and not np.any(np.isnan(of.values(lines, "discharge_line_pressure")))
    if peaks is not None and not has_line:
        yield of.row(_("peak pressure"), peaks, "peak_pressure", _after(of, peaks))
    if powers is None or of.alike(pressures, "indicated_mean_pressure") is None:
        sense = -1.0 if np.sum(of.values(pressures, "indicated_work")) < 0 else 1.0
        yield of.row(_("mean indicated pressure"), pressures, "indicated_mean_pressure", sense=sense)


def _after(of: Telling, peaks: PeakPressures) -> Message | None:
    """Words for where pressures are largest, if it is at the same angle in all chambers."""
    if np.all(np.abs(of.values(peaks, "peak_pressure_after")) < _AT_DEAD_CENTRE):
        return _("{values}, at the dead centre")
    angle = of.alike(peaks, "peak_pressure_after", unit="rad")
    if angle is None:
        return None
    after, before = _("{values}, {angle} after the dead centre"), _("{values}, {angle} before the dead centre")
    return (after if angle.value > 0 else before).format(angle=replace(angle, value=abs(angle.value)))


def compressor_rows(of: Telling, lines: CompressorCapacity, stages: CompressorStages | None) -> Iterator[AnswerLine]:
    """Between which pressures a compressor works, how warm it delivers, what it takes in and what flows."""
    suction = of.alike(lines, "suction_line_pressure")
    if suction is None:
        yield of.row(_("suction pressure"), lines, "suction_line_pressure")
    warm = of.alike(lines, "discharge_temperature")
    is_said = suction is not None and warm is not None
    words = _("{values} at {warm}, suction {suction}", suction=suction, warm=warm) if is_said else None
    yield of.row(_("discharge pressure"), lines, "discharge_line_pressure", words)
    if not is_said:
        yield of.row(_("discharge temperature"), lines, "discharge_temperature")
    yield of.row(_("takes in"), lines, "volumetric_efficiency", _("{values} of the swept volume"), unit="%")
    if stages is not None:
        said = N_("{total_inlet_flow} at the inlet, {total_mass_flow}, {specific_power}")
        yield of.line(_("capacity"), said, stages)


def power_rows(
    of: Telling, indicated: IndicatedPowers, pressures: GasPressures, brake: BrakePowers | None
) -> Iterator[AnswerLine]:
    """Indicated power, by bank where there are several, with its mean pressure; and what the shaft gives or takes."""
    is_taken = of.values(indicated, "indicated_power") < 0
    sense = -1.0 if is_taken else 1.0
    name = _("indicated power taken") if is_taken else _("indicated power")
    total = of.amount(indicated, "indicated_power", sense=sense)
    pressure = of.amount(indicated, "mean_indicated_pressure", sense=sense)
    is_one = of.alike(pressures, "indicated_mean_pressure") is not None
    if len(of.labels["bank"]) > 1 and of.alike(indicated, "bank_indicated_power") is None:
        words = _("{values}, {total} in all, {pressure}", total=total, pressure=pressure)
        words = words if is_one else _("{values}, {total} in all", total=total)
        yield of.row(name, indicated, "bank_indicated_power", words, sense=sense)
    else:
        words = _("{values}, {pressure}", pressure=pressure) if is_one else None
        yield of.row(name, indicated, "indicated_power", words, sense=sense)
    if brake is not None:
        is_driven = of.values(brake, "brake_power") < 0
        sense = -1.0 if is_driven else 1.0
        words = _(
            "{values}, {torque}, {pressure}",
            torque=of.amount(brake, "brake_torque", sense=sense),
            pressure=of.amount(brake, "mean_brake_pressure", sense=sense),
        )
        name = _("driven with") if is_driven else _("brake power")
        yield of.row(name, brake, "brake_power", words, sense=sense)


def heat_rows(of: Telling, heat: HeatBalance) -> Iterator[AnswerLine]:
    """Heat that comes in, what becomes of it."""
    loss, part = of.alike(heat, "wall_loss"), of.alike(heat, "working_turn_efficiency", unit="%")
    is_said = loss is not None and part is not None
    words = _("{values} a cycle: {part} work, {loss} to the walls", part=part, loss=loss) if is_said else None
    yield of.row(_("heat"), heat, "released_heat", words)
