"""Tables of the ideal cycles: what the dual cycle declares, and what all three have in common."""

from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from cranktrain.fluids.dual.pressure import IdealCycle
from cranktrain.fluids.exchange import Exponent, GasExchangeSpec
from cranktrain.language import N_, Words, _
from cranktrain.quantities import Dimension, Given, Quantity, shown

_LEAST_EXPONENT, _MOST_EXPONENT = 1.0, 5 / 3
"""Of an isotherm, and of a gas of single atoms."""

HeatRatio = Annotated[Given, Quantity(Dimension.RATIO, at_least=1.0)]

_ONE = Given(1.0, "1")
_LOWEST_USUAL = 0.5e5
"""Absolute pressure at which no engine breathes in; below it, a gauge pressure may be meant. [Pa]"""


RAISED: Mapping[str, str] = dict.fromkeys(("lambda", "λ", "psi", "ψ"), "pressure_ratio")
CUT_OFF: Mapping[str, str] = dict.fromkeys(("rho", "ρ"), "cut_off_ratio")
"""What books call both ratios."""


class IdealCycleSpec(GasExchangeSpec, frozen=True):
    """Ideal cycle with gas exchange: pressures, which are absolute, and exponents of the polytropes."""

    elsewhere: ClassVar = {
        **GasExchangeSpec.elsewhere,
        **dict.fromkeys(("n1", "k1"), "compression_exponent"),
        **dict.fromkeys(("n2", "k2"), "expansion_exponent"),
        **dict.fromkeys(("k", "n", "gamma"), "compression_exponent"),
        **dict.fromkeys(("pa", "p_a", "p1"), "start_pressure"),
    }

    compression_exponent: Exponent = Field(description=N_("Exponent n of the compression, p·Vⁿ = const."))
    expansion_exponent: Exponent = Field(description=N_("Exponent n of the expansion, p·Vⁿ = const."))


class DualSpec(IdealCycleSpec, frozen=True):
    """Dual cycle: heat first at constant volume, then at constant pressure."""

    elsewhere: ClassVar = {**IdealCycleSpec.elsewhere, **RAISED, **CUT_OFF}

    kind: Literal["dual"] = Field(description=N_("Kind of gas model."))
    pressure_ratio: HeatRatio = Field(description=N_("By how much heat at constant volume raises the pressure, p₃/p₂."))
    cut_off_ratio: HeatRatio = Field(
        description=N_("Volume when heat at constant pressure ends, over the smallest volume.")
    )


def ideal_cycle(spec: IdealCycleSpec) -> IdealCycle:
    """Give the numbers of any of the three cycles in SI; the ratio that it has not is 1."""
    ratios: list[Given] = [getattr(spec, name, _ONE) for name in ("pressure_ratio", "cut_off_ratio")]
    given = (spec.compression_exponent, spec.expansion_exponent, *ratios)
    return IdealCycle(spec.start_pressure.array, *spec.exchange_pressures, *(one.array for one in given))


def cycle_flags(spec: IdealCycleSpec) -> tuple[Words, ...]:
    """Flag pressures that are so low that gauge pressures may be meant, and exponents that no gas has."""
    exponents = {name: getattr(spec, name) for name in ("compression_exponent", "expansion_exponent")}
    unusual = tuple(
        _("{name} = {given} is no polytrope of an engine; 1.2 to 1.4 are usual.", name=name, given=exponent.text)
        for name, exponent in exponents.items()
        if not _LEAST_EXPONENT <= exponent.si <= _MOST_EXPONENT
    )
    names = ("start_pressure", "inlet_pressure", "exhaust_pressure")
    given = [(name, pressure) for name in names if (pressure := getattr(spec, name)) is not None]
    gauge = tuple(
        _(
            "{name} = {given} is {pressure} kPa absolute: if it is a gauge pressure, write it in barg, ati or psig.",
            name=name,
            given=pressure.text,
            pressure=f"{shown(pressure.si, 'kPa'):.4g}",
        )
        for name, pressure in given
        if pressure.si < _LOWEST_USUAL
    )
    return (*gauge, *unusual)
