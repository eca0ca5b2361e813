"""Machines to test with, and what they do by closed forms that share nothing with the kernels."""

from typing import Any

import numpy as np

import cranktrain as ct
from cranktrain.numerics.nested import filled, leaves, mapped

RADIUS, ROD = 0.05, 0.18
"""Of `slider`. [m]"""

V12: dict[str, Any] = {
    "shaft": {
        "main": {
            "throws": ["0 deg", "240 deg", "120 deg", "120 deg", "240 deg", "0 deg"],
            "spacing": "180 mm",
            "speed": "1500 rpm",
        }
    },
    "bank": {
        "L": {
            "angle": "-30 deg",
            "mechanism": {"kind": "slider_crank", "crank_radius": "90 mm", "rod_length": "320 mm"},
        },
        "R": {
            "angle": "30 deg",
            "mechanism": {
                "kind": "articulated_rod",
                "master": "L",
                "knuckle_radius": "85 mm",
                "rod_length": "235 mm",
                "articulation_angle": "67 deg",
            },
        },
    },
    "cylinder": {
        "bore": "150 mm",
        "compression_ratio": 14.5,
        "cycle": "four-stroke",
        "firing_order": "1L-6R-5L-2R-3L-4R-6L-1R-2L-5R-4L-3R",
    },
}
"""A V12 with articulated rods, all of the 3D12 that its rods are often quoted with."""

ROCKER: dict[str, Any] = {
    "kind": "crank_rocker",
    "crank_radius": "100 mm",
    "rod_length": "360 mm",
    "rocker_length": "280 mm",
    "ground_length": "400 mm",
}


def slider(**changes: Any) -> dict[str, Any]:
    """The table of a slider-crank of 50 and 180 mm."""
    return {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "180 mm", **changes}


def slave(master: str, **changes: Any) -> dict[str, Any]:
    """The table of an articulated rod that hangs on such a slider-crank."""
    return {
        "kind": "articulated_rod",
        "master": master,
        "knuckle_radius": "45 mm",
        "rod_length": "135 mm",
        "articulation_angle": "60 deg",
        **changes,
    }


def throws(*degrees: float, **fields: Any) -> dict[str, Any]:
    """The table of shafts for throws at these angles."""
    return {"main": {"throws": [f"{angle!r} deg" for angle in degrees], **fields}}


def banks(**angles: Any) -> dict[str, Any]:
    """Banks of such slider-cranks by name, each in its direction or with all of its table."""
    return {
        name: table if isinstance(table, dict) else {"angle": f"{table!r} deg", "mechanism": slider()}
        for name, table in angles.items()
    }


def of(result: ct.Result, name: str, values: Any) -> Any:
    """What an array by piston holds for one of them."""
    return values[..., result.labels["piston"].index(name)]


def curve(result: ct.Result, name: str, quantity: str = "piston_displacement") -> np.ndarray:
    """One piston's curve."""
    return getattr(result, quantity)[result.labels["piston"].index(name)]


def slider_position(alpha: Any, radius: float = RADIUS, rod: float = ROD, offset: float = 0.0) -> Any:
    """Distance of a slider from the shaft, by Pythagoras."""
    return radius * np.cos(alpha) + np.sqrt(rod**2 - (radius * np.sin(alpha) - offset) ** 2)


def slave_position(
    alpha: Any,
    *,
    bank_angle: float,
    articulation_angle: float,
    radius: float = RADIUS,
    master_rod: float = ROD,
    knuckle_radius: float = 0.045,
    rod: float = 0.135,
) -> Any:
    """Distance of a slave's slider from the shaft: its rod's circle about the knuckle meets the cylinder's axis."""
    beta = np.arcsin(radius / master_rod * np.sin(alpha))
    knuckle = radius * np.exp(1j * alpha) + knuckle_radius * np.exp(1j * (articulation_angle - beta))
    along = knuckle * np.exp(-1j * bank_angle)
    return along.real + np.sqrt(rod**2 - along.imag**2)


def travel(position: Any) -> Any:
    """Displacement from the top, where the top is on the grid."""
    return np.max(position) - position


def turned(angle: Any) -> Any:
    """Degrees within half a turn of 0, to compare angles that count round."""
    return (np.asarray(angle) + 180.0) % 360.0 - 180.0


def scaled(geometry, length, factor):
    """Geometry with one length, named by its dotted path, multiplied by a factor."""
    return mapped(lambda name, value: value * factor if name == length else value, geometry)


def as_columns(*designs):
    """Geometry of one member in several designs: arrays of shape (design,)."""
    return filled(designs[0], iter(np.array([leaves(design) for design in designs]).T))
