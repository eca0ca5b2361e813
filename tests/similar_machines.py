"""Machines geometrically similar to one: every quantity of their tables times the power of the size that it goes with.

Pressures, temperatures, angles and mean piston speeds stay, so all stresses and ratios do.
"""

import re
from collections.abc import Mapping

POWERS = {
    **dict.fromkeys(("mm", "cm", "m", "in"), 1),
    **dict.fromkeys(("rpm", "rad/s", "Hz"), -1),
    **dict.fromkeys(("N", "kN", "lbf"), 2),
    **dict.fromkeys(("kg", "g", "lb"), 3),
    **dict.fromkeys(("N·m", "N*m", "kN·m", "J", "kJ"), 3),
    **dict.fromkeys(("N/m", "kN/mm"), 1),
    **dict.fromkeys(("kg·m²", "kg*m^2"), 5),
    **dict.fromkeys(("kW", "W"), 2),
    **dict.fromkeys(("s", "ms"), 1),
    **dict.fromkeys(("deg", "bar", "kPa", "MPa", "GPa", "Pa", "K", "°C", "%", "W/(m²·K)"), 0),
}
"""Of the size, by unit: speeds of rotation go with its inverse, forces with its square, masses with its cube."""
_QUANTITY = re.compile(r"(-?[\d.]+(?:e-?\d+)?) (\S+)")


def similar(table, size):
    """A machine's tables for one so many times as large."""
    if isinstance(table, Mapping):
        return {key: similar(value, size) for key, value in table.items()}
    if isinstance(table, list | tuple):
        return [similar(value, size) for value in table]
    found = _QUANTITY.fullmatch(table) if isinstance(table, str) else None
    if found is None:
        return table
    return f"{float(found[1]) * size ** POWERS[found[2]]!r} {found[2]}"
