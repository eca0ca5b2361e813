"""The table of a motor with slip rings: rings shorted, with a constant resistance, or with a rheostat in steps."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, Words, _
from cranktrain.motion import ONE, Array, single
from cranktrain.motors.declared import DeclaredMotor
from cranktrain.motors.induction.breakdown_slip import slip_from_rated
from cranktrain.motors.induction.kloss import slip_of
from cranktrain.motors.induction.spec import AboveOne, AtLeastOne, InductionSpec
from cranktrain.motors.law import MotorLaw
from cranktrain.motors.spec import RatedSlip, first, missing_keys, out_of_place
from cranktrain.motors.wound_rotor.law import WOUND_ROTOR, WoundRotor
from cranktrain.motors.wound_rotor.rheostat import (
    STEPPED_ROTOR,
    TIMED_ROTOR,
    Rheostat,
    SteppedRotor,
    TimedRotor,
    resistance_steps,
)
from cranktrain.quantities import Dimension, Given, PositiveRatio, PositiveTime, PositiveTorque, Quantity
from cranktrain.spec import Spec

VoltageRatio = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=1.5)]


class RheostatSpec(Spec, frozen=True):
    """Resistance in steps of one ratio; they go out as the slip falls, or by time."""

    steps: int = Field(ge=1, le=50, description=N_("How many steps there are."))
    step_ratio: AboveOne | None = Field(
        default=None, description=N_("Resistance of the rotor's circuit before a step over that after it.")
    )
    peak_ratio: PositiveRatio | None = Field(
        default=None, description=N_("Torque to which every step goes up, over rated torque; instead of step_ratio.")
    )
    interval: PositiveTime | None = Field(
        default=None, description=N_("Time after which each step goes out; by the slip without it.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find steps that are given twice, or not at all."""
        if self.step_ratio is not None and self.peak_ratio is not None:
            yield Problem("peak_ratio", None, _("must not stand beside step_ratio"))
        if self.step_ratio is None and self.peak_ratio is None:
            yield Problem("peak_ratio", None, _("is missing; give peak_ratio or step_ratio"))


class WoundRotorSpec(InductionSpec, frozen=True):
    """A motor with slip rings: rated point and breakdown ratio, or breakdown torque and slip."""

    kind: Literal["wound_rotor"] = Field(description=N_("Kind of motor."))
    breakdown_ratio: AboveOne | None = Field(default=None, description=N_("Breakdown torque over rated torque."))
    breakdown_torque: PositiveTorque | None = Field(
        default=None, description=N_("Largest torque of the motor that drives; instead of breakdown_ratio.")
    )
    breakdown_slip: PositiveRatio | None = Field(
        default=None, description=N_("Slip there, with the rings shorted; from the rated point unless given.")
    )
    resistance_ratio: AtLeastOne | None = Field(
        default=None,
        description=N_("All of the rotor's circuit, in parts of the rotor's own; 1 with the rings shorted."),
    )
    rheostat: RheostatSpec | None = Field(
        default=None, description=N_("Resistance in steps, instead of a constant one.")
    )
    voltage_ratio: VoltageRatio = Field(
        default=Given(1.0, "1"),
        description=N_("Voltage at the motor over the rated one; the torque goes with its square."),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find what is missing, given twice, or in the wrong order."""
        found = [*super()._problems(), *self.field_problems()]
        if self.breakdown_torque is not None:
            found += out_of_place(self, ("breakdown_ratio",), _("must not stand beside breakdown_torque"))
        else:
            found += missing_keys(self, ("breakdown_ratio",))
        needs_plate = self.breakdown_torque is None or self.breakdown_slip is None
        if self.has_no_plate and needs_plate:
            found += missing_keys(self, ("power", "speed"))
        if self.rheostat is not None:
            found += out_of_place(self, ("resistance_ratio",), _("must not stand beside rheostat"))
        if self.breakdown_torque is not None and self.is_rated and first(self._breakdown) <= 1:
            found.append(Problem("breakdown_torque", None, _("must be above the rated torque")))
        yield from found
        if not found:
            yield from self._step_problems()

    def _step_problems(self) -> Iterator[Problem]:
        """Find steps by a peak that no ratio above 1 gives."""
        if self.rheostat is None or self.rheostat.peak_ratio is None:
            return
        path, peak = "rheostat.peak_ratio", self.rheostat.peak_ratio
        if not self.is_rated:
            yield Problem(path, peak.text, _("needs the rated point, power and speed; or give step_ratio"))
        elif first(self._step_ratio) <= 1 or peak.si > first(self._breakdown):
            most = min(first(self._breakdown), 1 / first(self._rated_slip))
            allowed = _("must be at most the breakdown torque and at less than standstill, {most}")
            yield Problem(path, peak.text, allowed.format(most=f"{most:.4g}"))

    @property
    def _rated_slip(self) -> Array:
        return slip_of(self.rating.speed, self.field_speed)

    @property
    def _breakdown(self) -> Array:
        """Breakdown torque over the rated one."""
        if self.breakdown_torque is not None:
            return self.breakdown_torque.array / self.rating.torque
        return single(np.nan) if self.breakdown_ratio is None else self.breakdown_ratio.array

    @property
    def _rotor(self) -> WoundRotor:
        """Numbers of the rotor, rings shorted."""
        by_torque, by_slip = self.breakdown_torque, self.breakdown_slip
        torque = self._breakdown * self.rating.torque if by_torque is None else by_torque.array
        slip = slip_from_rated(self._rated_slip, self._breakdown) if by_slip is None else by_slip.array
        return WoundRotor(self.field_speed, torque * self.voltage_ratio.array * self.voltage_ratio.array, slip, ONE)

    @property
    def _step_ratio(self) -> Array:
        """Ratio of the rheostat's steps; 1 without one."""
        steps = self.rheostat
        if steps is None:
            return ONE
        if steps.step_ratio is not None:
            return steps.step_ratio.array
        peak = ONE if steps.peak_ratio is None else steps.peak_ratio.array
        return resistance_steps(steps.steps, peak, self._rated_slip).ratio

    @property
    def largest_torque(self) -> Array:
        """Breakdown torque at the voltage that is there, whatever is in the rotor's circuit. [N·m]"""
        return self._rotor.breakdown_torque

    @property
    def slip_at_rating(self) -> RatedSlip:
        """Slip at the rated torque with what is in the rotor's circuit, but a rheostat."""
        if not self.is_rated:
            return RatedSlip(np.nan, np.nan, is_by_resistance=True)
        slip = first(self._rated_slip) * first(self._resistance)
        return RatedSlip(slip, first(self.rating.power), is_by_resistance=True)

    def declared(self) -> DeclaredMotor:
        """Give the motor in SI."""
        law, numbers = self._by_circuit()
        return DeclaredMotor(
            law,
            numbers,
            self.rating,
            self.field_speed,
            self.rotor_inertia,
            slip_ratio=self._resistance if self.rheostat is None else ONE,
            notes=tuple(self.field_notes()),
            flags=tuple(self._flags()),
        )

    @property
    def _resistance(self) -> Array:
        """All of the rotor's circuit, without a rheostat, in parts of the rotor's own."""
        return ONE if self.resistance_ratio is None else self.resistance_ratio.array

    def _by_circuit(self) -> tuple[MotorLaw[Any], Any]:
        """Law and numbers by what is in the rotor's circuit."""
        rotor, steps = self._rotor, self.rheostat
        if steps is None:
            return WOUND_ROTOR, rotor._replace(resistance=self._resistance)
        rheostat = Rheostat(self._step_ratio, single(float(steps.steps)))
        if steps.interval is None:
            return STEPPED_ROTOR, SteppedRotor(rotor, rheostat)
        return TIMED_ROTOR, TimedRotor(rotor, rheostat, steps.interval.array)

    def _flags(self) -> Iterator[Words]:
        """Steps that are too few for the rated load; of the first design."""
        if self.rheostat is None or self.rheostat.peak_ratio is None or self.rheostat.interval is not None:
            return
        low = self.rheostat.peak_ratio.si / first(self._step_ratio)
        if low < 1:
            said = _("Steps of the rheostat go out at {low} times the rated torque: too few of them for a full load.")
            yield said.format(low=f"{low:.3g}")
