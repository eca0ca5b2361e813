"""Random machine files over all tables: a mechanism that mostly closes, and what may stand beside it."""

import json
import re

from random_drives import drive, wanted_motion
from random_tables import SCHEMA, Maker


def mechanism(make: Maker) -> dict:
    """A mechanism that mostly closes, by its kind."""
    size, any_ = make.size, make.any

    def length(value: float) -> str:
        return make.text(value, "length")

    kind = any_.choices(
        ("slider_crank", "crank_rocker", "scotch_yoke", "oscillating_cylinder", "slotted_lever", "eccentric", "chain"),
        (8, 3, 2, 1, 1, 1, 2),
    )[0]
    make.links, make.pistons = ["crank", "rod", "piston"], ["piston"]
    near = any_.choice((0.999, 1.0, 1.0, 1.001)) if make.chance(0.05) else None
    ratio = any_.uniform(1.2, 6) if near is None else near
    optional = {"offset": length(size * any_.gauss(0, 0.05))} if make.chance(0.25) else {}
    match kind:
        case "slider_crank":
            crank = {"stroke": length(2 * size)} if make.chance(0.4) else {"crank_radius": length(size)}
            rod = any_.choice(
                (
                    {"rod_length": length(size * ratio)},
                    {"rod_to_crank_ratio": round(ratio, 3)},
                    {"crank_to_rod_ratio": round(1 / ratio, 3)},
                )
            )
            own = crank | rod | optional
        case "crank_rocker":
            make.links, make.pistons = ["crank", "rod", "rocker"], ["rocker"]
            ground = any_.uniform(2.5, 6)
            rocker = any_.uniform(1.6, ground)
            rod = ground - rocker + 1 + any_.uniform(0.1, 1) * min(1.0, rocker - 1)
            own = {
                "crank_radius": length(size),
                "rod_length": length(size * rod),
                "rocker_length": length(size * rocker),
            }
            own |= {"ground_length": length(size * ground)}
            if make.chance(0.4):
                own |= {
                    "side": any_.choice(("left", "right")),
                    "load_radius": length(size),
                    "load_direction": any_.choice(("with", "against")),
                }
        case "scotch_yoke":
            make.links = ["crank", "piston"]
            own = {"crank_radius": length(size)} | optional
            if make.chance(0.2):
                own["slot_angle"] = make.text(any_.uniform(0.5, 2.6), "angle")
        case "oscillating_cylinder" | "slotted_lever":
            make.links, make.pistons = ["crank", "rod", "lever", "piston"], ["piston"]
            own = {"crank_radius": length(size), "ground_length": length(size * ratio)} | optional
        case "eccentric":
            own = {"eccentricity": length(size), "rod_length": length(size * ratio)} | optional
            own |= any_.choice(
                (
                    {},
                    {"angle_ahead": make.text(1.5, "angle")},
                    {"angle_of_advance": make.text(0.5, "angle"), "admission": "inside"},
                )
            )
        case _:
            make.links, make.pistons = ["main", "rod", "ram"], ["ram"]
            guide = {"through": "O", "direction": make.text(any_.choice((0.0, 1.0, -1.5)), "angle")}
            part = {
                "type": "slide",
                "rod": {"name": "rod", "from": "main.pin", "length": length(size * ratio)},
                "slider": "ram",
                "guide": guide,
            }
            own = {"output": "ram", "crank": {"main": {"radius": length(size)}}, "part": [part]}
    return {"kind": kind, **own}


def masses(make: Maker) -> dict:
    """Masses of some links."""
    found = {}
    for link in make.links:
        if make.chance(0.6):
            found[link] = make.table(
                "Body", part=0.3, leave=("flywheel_moment", "big_end", "small_end"), must=("mass",)
            )
    if not found and make.chance(0.5):
        found[make.links[-1]] = {"mass": make.quantity("mass-above-0")}
    return found


def load(make: Maker) -> dict:
    """A load on a link: one size, over angles, over travel, or by a power of the speed."""
    on = make.any.choice([*make.links, make.links[-1], make.links[-1], "main"])
    is_torque = on in ("main", "crank", "rocker", "lever")
    key = "torque" if is_torque else "force"
    own: dict = {"on": on}
    match make.any.randint(0, 4):
        case 0 | 1:
            own[key] = make.quantity(key)
        case 2:
            own["crank_angles"] = ["0 deg", "90 deg", "200 deg"]
            own[key] = [make.quantity(key) for _ in range(3)]
        case 3 if not is_torque:
            own["travel"] = [make.text(make.size * at, "length") for at in (0.0, 1.7, 1.8, 2.3)]
            own[key] = [f"{sign * make.near(key):.3g} N" for sign in (0, 0, 1, 1)]
            if make.chance(0.7):
                own["force_back"] = ["0 N"] * 4
        case _:
            own |= {key: make.quantity(f"{key}"), "exponent": make.any.choice((1, 2, 1.75, 0.5, 0))}
            own |= {
                "at_turning" if is_torque else "at_speed": make.quantity(
                    "speed-above-0" if is_torque else "velocity-above-0"
                )
            }
    if on == "rod":
        own |= {"along": make.text(make.size, "length"), "direction": make.quantity("angle")}
    if make.chance(0.3):
        own["sense"] = make.any.choice(("resisting", "active"))
    if make.chance(0.05):
        own |= make.table("Load", part=0.2, leave=("file", "text", "on"))
    return own


def crankshaft(make: Maker) -> dict:
    """Diameters and lengths of a shaft that may bear the machine."""
    size = make.size
    sizes = {
        "journal_diameter": 0.9,
        "pin_diameter": 0.8,
        "pin_length": 0.4,
        "web_thickness": 0.3,
        "web_width": 1.2,
        "bearing_distance": 2.0,
    }
    found = {
        key: make.text(size * at * make.any.uniform(0.7, 1.4), "length")
        for key, at in sizes.items()
        if make.chance(0.93)
    }
    if make.chance(0.4):
        found |= {
            "bearing_stiffness": make.quantity("stiffness-above-0"),
            "bearing_width": make.text(size * 0.3, "length"),
        }
    leave = (*sizes, "bearing", "pull", "journals", "bearings")
    return found | make.table("Crankshaft", part=make.any.choice((0.0, 0.15)), leave=leave)


def torsion(make: Maker) -> dict:
    """Discs on the crankshaft."""
    found = make.table("Torsion", part=0.5, leave=("disc", "free_end"))
    discs = {
        "flywheel": {
            "inertia": make.quantity("inertia-above-0"),
            "beside": make.n_throws,
            "stiffness": make.quantity("torsional-stiffness-above-0"),
        }
    }
    if make.chance(0.3):
        discs["damper"] = {"inertia": make.quantity("inertia-above-0"), "beside": make.any.choice((1, "flywheel"))}
    return found | {"disc": discs}


def gas_and_cylinder(make: Maker) -> tuple[dict, dict]:
    """A cylinder, and mostly what is in it."""
    any_ = make.any
    cylinder: dict = {"bore": make.text(make.size * any_.uniform(0.5, 3), "length")}
    kind = any_.choice(("otto", "diesel", "dual", "wiebe", "compressor", None))
    if make.chance(0.9):
        cylinder |= (
            {"clearance": round(any_.uniform(0.02, 0.3), 3)}
            if kind == "compressor"
            else {"compression_ratio": round(any_.uniform(1.1, 20), 3)}
        )
    if kind != "compressor" and make.chance(0.8):
        cylinder |= {
            "cycle": any_.choice(("two-stroke", "four-stroke")),
            "firing_order": "-".join(map(str, range(1, make.n_throws + 1))),
        }
    if make.chance(0.3):
        cylinder |= make.table(
            "Cylinders",
            part=0.15,
            leave=("firing_order", "firing_angles", "numbers", "bore", "compression_ratio", "clearance", "cycle"),
        )
    if kind is None:
        return cylinder, {}
    values = {
        "compression_exponent": 1.33,
        "expansion_exponent": 1.28,
        "start_pressure": "95 kPa",
        "discharge_pressure": "500 kPa",
    }
    gas = make.table(kind.capitalize(), part=0.3, leave=("takes_from",))
    for key in gas:
        if key in values and make.chance(0.9):
            gas[key] = values[key]
    if kind == "compressor":
        gas |= {
            "suction_pressure": "100 kPa",
            "discharge_pressure": make.text(1e5 * any_.uniform(1.01, 20), "pressure"),
        }
    if kind in ("diesel", "dual"):
        gas |= {key: round(any_.uniform(1, 2), 3) for key in ("cut_off_ratio", "pressure_ratio") if key in gas}
    return cylinder, gas


def machine(seed: int) -> dict:
    """A random machine file, as the tables it holds."""
    make = Maker(seed)
    own = mechanism(make)
    found: dict = {}
    for key in ("rotation", "running"):
        if make.chance(0.2):
            found[key] = make.any.choice(SCHEMA["properties"][key]["enum"])
    if make.chance(0.15):
        found["gravity"] = True
    shaft: dict = {}
    is_driven = make.chance(0.45)
    if is_driven and make.chance(0.25):
        shaft["motion"] = wanted_motion(make)
    elif make.chance(0.95):
        shaft["speed"] = make.text(make.speed, "speed")
    if own["kind"] == "slider_crank" and not is_driven and make.chance(0.4):
        make.n_throws = make.any.choice((1, 2, 2, 3, 4, 6))
        shaft["throws"] = [
            f"{make.any.choice((0, 90, 120, 180, 240, 270, 33)) if i else 0} deg" for i in range(make.n_throws)
        ]
        if make.chance(0.7):
            shaft["spacing"] = make.text(3 * make.size, "length")
        make.pistons = [str(i + 1) for i in range(make.n_throws)]
    found["shaft"] = {"main": shaft}
    if make.n_throws > 1 or make.chance(0.15):
        bank: dict = {"mechanism": own}
        found["bank"] = {"A": bank}
        if make.chance(0.2):
            found["bank"]["B"] = {
                "angle": make.text(make.any.choice((1.0, 1.5708, 3.1416)), "angle"),
                "mechanism": mechanism_like(own),
            }
            bank["angle"] = "0 deg"
    elif make.chance(0.05) and own["kind"] == "slider_crank":
        found["shaft"]["upper"] = {"place": ["0 mm", make.text(make.size * make.any.uniform(6, 20), "length")]}
        upper = {"shaft": "upper", "mechanism": mechanism_like(own)}
        found["bank"] = {"A": {"lead": make.quantity("angle"), "exhaust": {"mechanism": own}, "scavenge": upper}}
    else:
        found["mechanism"] = own
    parts = {
        "masses": (0.7, masses),
        "crankshaft": (0.3, crankshaft),
        "torsion": (0.15, torsion),
        "drive": (1.0 if is_driven else 0.0, drive),
        "evenness": (0.25, lambda m: m.table("Evenness", part=0.4)),
        "balance": (0.12, lambda m: m.table("Balance", part=0.4)),
        "friction": (0.12, lambda m: {m.any.choice([*m.links, "pins"]): m.quantity("ratio-from-0-below-1")}),
        "guide": (0.08, lambda m: {m.links[-1]: m.table("Guide", part=0.5)}),
    }
    for key, (part, made) in parts.items():
        if make.chance(part):
            found[key] = made(make)
    if make.chance(0.45):
        found["load"] = {f"l{i}": load(make) for i in range(make.any.choice((1, 1, 2)))}
        if make.chance(0.1):
            found["pumping"] = {"card": "l0"} | make.table("Pumping", part=0.3, leave=("card",))
    if own["kind"] in ("slider_crank", "scotch_yoke", "eccentric", "oscillating_cylinder") and make.chance(0.35):
        cylinder, gas = gas_and_cylinder(make)
        found["cylinder"] = cylinder
        if gas:
            found["gas"] = gas
    _spoilt(make, found)
    return {key: value for key, value in found.items() if value != {} or key == "drive"}


def mechanism_like(own: dict) -> dict:
    """The same mechanism once more."""
    return json.loads(json.dumps(own))


def _spoilt(make: Maker, found: dict) -> None:
    """Now and then leave something out, or set it beside what it may be."""
    while make.chance(0.12):
        table = found
        while True:
            inner = [value for value in table.values() if isinstance(value, dict) and value]
            if not inner or make.chance(0.3):
                break
            table = make.any.choice(inner)
        if not table:
            return
        key = make.any.choice(list(table))
        if make.chance(0.6):
            del table[key]
        elif isinstance(table[key], str):
            unit = table[key].partition(" ")[2]
            table[key] = f"{make.any.choice((0, -1, 1e-9, 1e9, 1e300))} {unit}".strip()


def mended(tables: dict, paths: list[str]) -> dict | None:
    """Leave out what is told to be wrong, or the table in which something is missing; None if that is the mechanism."""
    changed = False
    for path in paths:
        keys: tuple = tuple(int(one) if one.isdigit() else one for one in re.findall(r"[^.\[\]]+", path))
        while keys and not _has(tables, keys):
            keys = keys[:-1]
        if keys and keys[-1] not in ("mechanism", "bank", "A", "shaft"):
            tables, changed = without(tables, keys), True
    return tables if changed else None


def _has(table, keys: tuple) -> bool:
    for key in keys:
        try:
            table = table[key]
        except (KeyError, IndexError, TypeError):
            return False
    return True


def without(table, path):
    """A copy without what stands at a path."""
    key, *rest = path
    if isinstance(table, dict):
        if not rest:
            return {name: value for name, value in table.items() if name != key}
        return {name: without(value, rest) if name == key else value for name, value in table.items()}
    if not rest:
        return [value for at, value in enumerate(table) if at != key]
    return [without(value, rest) if at == key else value for at, value in enumerate(table)]
