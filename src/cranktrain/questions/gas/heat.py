"""What becomes of the heat that comes in by Wiebe's law."""

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.questions.gas.declared import DeclaredGas
from cranktrain.record import record
from cranktrain.references import THEORY_OF_GAS as _THEORY
from cranktrain.saying.catalogue import quantity

_CHAMBER = ("chamber",)


@record
class HeatBalance:
    """Heat of each chamber over a cycle; NaN of chambers with another gas."""

    released_heat: Array = quantity("Q_b", "J", _CHAMBER, N_("Heat that comes in over a cycle"), _THEORY, "14.22")
    wall_loss: Array = quantity(
        "Q_w", "J", _CHAMBER, N_("Heat that the walls take in the working turn"), _THEORY, "14.22"
    )
    working_turn_efficiency: Array = quantity(
        "η_i",
        "1",
        _CHAMBER,
        N_("Work of the gas in the working turn over the heat that comes in"),
        _THEORY,
        "14.27",
    )


def has_heat(gas: DeclaredGas) -> bool:
    """Say whether heat comes in by Wiebe's law in any chamber."""
    return any(table.fluid.name == "wiebe" for table in gas.tables)


def heat_balance(gas: GasInChambers) -> HeatBalance:
    """Heat, loss and work of the working turn; docs/theory/gas, eq. (14.22)."""
    burning = gas.filled_with("wiebe")
    heat = gas.by_chamber((one, one.ready.heat) for one in burning)
    loss, work = (gas.by_chamber((one, getattr(one.ready.curve, name)) for one in burning) for name in ("loss", "work"))
    return HeatBalance(released_heat=heat, wall_loss=loss, working_turn_efficiency=work / heat)
