"""Powers: of the gas on the pistons, what friction takes of it, and what comes out at the shaft."""

from typing import ClassVar

import numpy as np

from cranktrain.fluids.work import friction_power, friction_power_by_efficiency, indicated_power
from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.questions.cylinders.firing import Cycle
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.questions.cylinders.volumes import Chambers, SweptVolumes
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.record import record
from cranktrain.references import THEORY_OF_GAS as _THEORY
from cranktrain.saying.catalogue import quantity


@record
class IndicatedPowers:
    """Power of the gas on the pistons at the mean speed."""

    indicated_power: Array = quantity("P_i", "W", (), N_("Power of the gas on all pistons"), _THEORY, "14.8")
    bank_indicated_power: Array = quantity(
        "P_b", "W", ("bank",), N_("Power of the gas on the bank's pistons"), _THEORY, "14.8"
    )
    mean_indicated_pressure: Array = quantity(
        "p_mi",
        "Pa",
        (),
        N_("Indicated mean effective pressure of all chambers: work over displacement"),
        _THEORY,
        "14.8",
        line="Σ {indicated_work} / {displacement}",
    )


def indicated_powers(
    gas: GasPressures, chambers: Chambers, swept: SweptVolumes, cycle: Cycle, speed: Speed
) -> IndicatedPowers:
    """Powers from the work of each chamber; docs/theory/gas, eq. (14.8)."""
    power = indicated_power(gas.indicated_work, np.array(cycle.length), speed.mean[..., 0])
    banks = [np.array(chambers.banks) == bank for bank in dict.fromkeys(chambers.banks)]
    return IndicatedPowers(
        indicated_power=np.sum(power, axis=-1),
        bank_indicated_power=np.stack([np.sum(power[:, own], axis=-1) for own in banks], axis=-1),
        mean_indicated_pressure=np.sum(gas.indicated_work, axis=-1) / swept.displacement,
    )


@record
class Losses:
    """Friction of the whole machine: a mechanical efficiency or a mean pressure, shape (design,); NaN is not given.

    pressure in Pa.
    """

    needs: ClassVar[str] = N_("[cylinder] mechanical_efficiency or friction_pressure")

    efficiency: Array
    pressure: Array


def losses_of(designs: Designs) -> Losses | None:
    """Take what the file says of friction; None where it says nothing."""
    spec = designs.together.table(CylindersSpec) or CylindersSpec()
    declared = (spec.mechanical_efficiency, spec.friction_pressure)
    found = designs.by_design([np.nan if given is None else given.array for given in declared])
    return None if np.all(np.isnan(found)) else Losses(*found.T)


@record
class BrakePowers:
    """What friction takes of the indicated power, and what the shaft gives; a driven machine takes it."""

    friction_power: Array = quantity("P_f", "W", (), N_("Power that friction takes"), _THEORY, "14.15")
    brake_power: Array = quantity(
        "P_e",
        "W",
        (),
        N_("Power that the shaft gives; negative where it is driven"),
        _THEORY,
        "14.15",
        line="{indicated_power} − {friction_power}",
    )
    brake_torque: Array = quantity("T_e", "N*m", (), N_("Mean torque that the shaft gives"), _THEORY, "14.26")
    mean_brake_pressure: Array = quantity(
        "p_me",
        "Pa",
        (),
        N_("Brake mean effective pressure: the shaft's work over displacement"),
        _THEORY,
        "14.15",
        line="{mean_indicated_pressure} · {brake_power} / {indicated_power}",
    )
    brake_efficiency: Array = quantity(
        "η_m",
        "1",
        (),
        N_("Mechanical efficiency: brake over indicated power; of a driven machine the inverse"),
        _THEORY,
        "14.15",
    )


def brake_powers(
    losses: Losses, indicated: IndicatedPowers, swept: SweptVolumes, cycle: Cycle, speed: Speed
) -> BrakePowers:
    """Friction by the mechanical efficiency, or by a constant mean pressure; docs/theory/gas, eq. (14.15)."""
    omega = speed.mean[:, 0, 0]
    length = np.array(cycle.length)
    gas = indicated.indicated_power
    lost = np.where(
        np.isnan(losses.efficiency),
        friction_power(losses.pressure, swept.displacement, length, omega),
        friction_power_by_efficiency(gas, losses.efficiency),
    )
    brake = gas - lost
    return BrakePowers(
        friction_power=lost,
        brake_power=brake,
        brake_torque=brake / omega,
        mean_brake_pressure=brake / indicated_power(swept.displacement, length, omega),
        brake_efficiency=np.where(gas > 0, brake / gas, gas / brake),
    )
