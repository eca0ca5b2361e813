"""Machines that work against loads, for pictures: one of each way in which a load acts."""

from tests.unit.questions.forces.test_friction import CHAIN

import cranktrain as ct

_TURNING = {"main": {"speed": "90 rpm"}}

LOADED = {
    "table": ct.Machine(
        name="Tilting table",
        shaft={"main": {"speed": "30 rpm"}},
        mechanism={
            "kind": "crank_rocker",
            "crank_radius": "100 mm",
            "rod_length": "600 mm",
            "rocker_length": "300 mm",
            "ground_length": "620 mm",
        },
        load={"drive": {"on": "rocker", "torque": "1200 N*m"}},
    ),
    "press": ct.Machine(
        name="Eccentric press",
        angle="180 deg",
        shaft=_TURNING,
        mechanism={"kind": "slider_crank", "stroke": "130 mm", "crank_to_rod_ratio": 0.1},
        load={
            "nominal_force": {
                "on": "piston",
                "force": ["0 kN", "0 kN", "1000 kN", "1000 kN"],
                "travel": ["0 mm", "122 mm", "122.5 mm", "130 mm"],
                "force_back": ["0 kN", "0 kN", "0 kN", "0 kN"],
            },
            "balancer": {"on": "piston", "force": "60 kN", "sense": "active", "direction": "180 deg"},
        },
    ),
    "crusher": ct.Machine(
        name="Jaw crusher",
        angle="176.82 deg",
        shaft={"main": {"speed": "275 rpm"}},
        mechanism={
            "kind": "crank_rocker",
            "crank_radius": "12 mm",
            "rod_length": "1085 mm",
            "rocker_length": "455 mm",
            "ground_length": "816.957 mm",
            "side": "right",
        },
        load={
            "stone": {
                "on": "rod",
                "along": "800 mm",
                "across": "60 mm",
                "direction": "95 deg",
                "sense": "active",
                "force": ["0 kN", "0 kN", "280 kN", "0 kN"],
                "crank_angles": ["0 deg", "60 deg", "170 deg", "200 deg"],
            }
        },
    ),
    "shaper": ct.Machine(
        name="Shaper",
        rotation="anticlockwise",
        angle="-90 deg",
        shaft={"main": {"speed": "30 rpm"}},
        mechanism={
            "kind": "chain",
            "output": "ram",
            "fixed": {"C": ["0 mm", "-250 mm"]},
            "crank": {"main": {"radius": "100 mm"}},
            "part": [
                {
                    "type": "swivel",
                    "pin": "main.pin",
                    "guide": {"name": "lever", "from": "C"},
                    "slider": "block",
                },
                {"type": "point", "name": "D", "link": "lever", "along": "500 mm"},
                {
                    "type": "slide",
                    "rod": {"name": "rod", "from": "D", "length": "300 mm"},
                    "slider": "ram",
                    "guide": {"through": "O", "direction": "0 deg", "offset": "230 mm"},
                },
            ],
        },
        load={
            "cut": {
                "on": "ram",
                "force": ["0 kN", "0 kN", "6 kN", "6 kN", "0 kN", "0 kN"],
                "travel": ["0 mm", "20 mm", "20.1 mm", "380 mm", "380.1 mm", "401 mm"],
                "counts": "against",
                "force_back": ["0 kN", "0 kN", "0 kN", "0 kN", "0 kN", "0 kN"],
            },
            "slideway": {"on": "ram", "force": "0.6 kN"},
        },
    ),
    "pumping_unit": ct.Machine(
        name="Beam pumping unit",
        angle="39.47245984834383 deg",
        crank_zero="Y",
        shaft={"main": {"speed": "10 rpm"}},
        mechanism={
            "kind": "crank_rocker",
            "crank_radius": "21 in",
            "rod_length": "65.63 in",
            "rocker_length": "56.05 in",
            "ground_length": "88.09086218218096 in",
            "side": "right",
            "load_direction": "against",
            "load_radius": "64 in",
        },
        load={
            "rope": {
                "on": "rocker",
                "sense": "active",
                "radius": "64 in",
                "direction": "140.52754015165617 deg",
                "counts": "against",
                "travel": ["0 mm", "190 mm", "1070 mm", "1258 mm"],
                "force": ["22 kN", "38 kN", "38 kN", "38 kN"],
                "force_back": ["22 kN", "22 kN", "22 kN", "38 kN"],
            }
        },
    ),
    "triad": ct.Machine(
        name="Chain with a triad",
        shaft=_TURNING,
        load={
            "valve_spring": {"on": "valve", "force": "-300 N", "sense": "active"},
            "brake": {"on": "plate", "torque": "9 N*m"},
            "drag": {"on": "lever", "along": "120 mm", "force": "150 N", "at_speed": "0.2 m/s", "exponent": 2},
        },
        **CHAIN,
    ),
}
