"""Random machine files over all tables: mostly possible, at any size, now and then at a border or beyond it.

What a table may say is read from the schema, so that a new key is tried without a word here. A mechanism is made by
hand, so that it mostly closes; numbers of the other tables are near what a machine of that size and speed would have.
"""

import json
import math
import random
import re

from cranktrain.io.schema import schema_text

SCHEMA = json.loads(schema_text())
_BOUND = re.compile(
    r"^(?P<dimension>[a-z-]*?)(?:-(?P<low>above|from)-(?P<least>-?[\d.e-]+?))?(?:-(?P<high>to|below)-(?P<most>[\d.e-]+))?$"
)
_SORTED = ("speeds", "times", "crank_angles", "travel")
_ODD = 0.02
"""Part of the numbers that stand at a border, or are far from what a machine would have."""
_UNITS = {
    "length": "m", "mass": "kg", "angle": "rad", "speed": "rad/s", "torque": "N·m", "force": "N", "power": "W", "time": "s",
    "inertia": "kg·m²", "flywheel-moment": "kg·m²", "pressure": "Pa", "temperature": "K", "velocity": "m/s",
    "frequency": "Hz", "density": "kg/m³", "stiffness": "N/m", "torsional-stiffness": "N·m/rad", "current": "A",
    "voltage": "V", "resistance": "Ω", "energy": "J", "acceleration": "m/s²", "angular-acceleration": "rad/s²",
    "heat-transfer": "W/m²/K", "ratio": "",
}  # fmt: skip


class Maker:
    """One random machine: its size and speed, and all that follows from these."""

    def __init__(self, seed: int) -> None:
        self.any = random.Random(seed)
        self.size = 10 ** self.any.choice((-1.0, -1.0, -1.0, self.any.uniform(-3, 1), self.any.uniform(-6, 4)))
        self.speed = 10 ** self.any.choice((1.0, 2.0, self.any.uniform(0, 3), self.any.uniform(-4, 5)))
        mass = 1e3 * self.size**3
        force = mass * self.size * self.speed**2
        torque, pressure = force * self.size, 1e5
        self.scales = {
            "length": self.size, "mass": mass, "angle": 1.0, "speed": self.speed, "torque": torque, "force": force,
            "power": torque * self.speed, "time": 5 / self.speed, "inertia": mass * self.size**2,
            "flywheel-moment": 4 * mass * self.size**2, "pressure": pressure, "temperature": 300.0,
            "velocity": self.size * self.speed, "frequency": self.speed / 6, "density": 7850.0,
            "stiffness": 1e9 * self.size, "torsional-stiffness": 1e8 * self.size**3, "current": torque * self.speed / 400,
            "voltage": 400.0, "resistance": 400.0**2 / max(torque * self.speed, 1e-12), "energy": pressure * self.size**3,
            "acceleration": 9.81, "angular-acceleration": self.speed**2, "heat-transfer": 500.0, "ratio": 1.0,
        }  # fmt: skip
        self.links: list[str] = []
        self.pistons: list[str] = []
        self.n_throws = 1

    def chance(self, part: float) -> bool:
        return self.any.random() < part

    def near(self, dimension: str, *, spread: float = 0.4) -> float:
        return self.scales[dimension] * 10 ** self.any.gauss(0.0, spread)

    def text(self, value: float, dimension: str) -> str | float:
        """Write a number with its unit, by few digits, so that what is round meets what is rounded."""
        rounded = float(f"{value:.{self.any.choice((1, 2, 3, 6, 17))}g}")
        unit = _UNITS[dimension]
        if dimension == "angle" and self.chance(0.7):
            rounded, unit = (
                float(round(math.degrees(value) / 5) * 5 if self.chance(0.6) else math.degrees(value)),
                "deg",
            )
        return f"{rounded!r} {unit}" if unit else rounded

    def quantity(self, name: str) -> str | float:
        """A quantity by its name in the schema, which has dimension and bounds."""
        found = _BOUND.match(name)
        if found is None or found["dimension"] not in _UNITS:
            raise KeyError(name)
        dimension = found["dimension"]
        low = None if found["least"] is None else float(found["least"])
        high = None if found["most"] is None else float(found["most"])
        if self.chance(_ODD):
            odd = (0.0, 1.0, -1.0, 1e-12, 1e9, low, high, self.near(dimension, spread=4.0))
            return self.text(next(x for x in self.any.choices(odd, k=40) if x is not None), dimension)
        if dimension == "angle":
            value = self.any.uniform(-math.pi if low is None else low, math.pi if high is None else high)
        elif low is not None and high is not None and high <= 10:
            value = self.any.uniform(low, high)
        else:
            value = self.near(dimension)
            value = value + low if low is not None and low > 0 else value
            if low is None and dimension in ("length", "torque", "force", "speed") and self.chance(0.4):
                value = -value
        return self.text(value, dimension)

    def of_schema(self, schema: dict, key: str, sizes: dict[str, int]):
        """Anything that a part of the schema allows."""
        if "$ref" in schema:
            name = schema["$ref"].split("/")[-1]
            target = SCHEMA["$defs"][name]
            return self.table(name) if "properties" in target else self.quantity(name)
        if "if" in schema and "then" in schema:
            other = schema.get("else", schema["then"])
            return self.of_schema(other if self.chance(0.7) else schema["then"], key, sizes)
        if "anyOf" in schema or "oneOf" in schema:
            return self.of_schema(self.any.choice(schema.get("anyOf") or schema["oneOf"]), key, sizes)
        if "enum" in schema:
            return self.any.choice(schema["enum"])
        match schema.get("type"):
            case "boolean":
                return self.chance(0.5)
            case "integer" | ["integer"]:
                return self.any.randint(1, self.n_throws + 2)
            case "number":
                return self.near("ratio")
            case "array":
                items = [
                    self.of_schema(schema["items"], key, sizes)
                    for _ in range(sizes.setdefault(key, self.any.randint(1, 4)))
                ]
                return items
            case "object":
                if "allOf" in schema:
                    kind = self.any.choice(schema["properties"]["kind"]["enum"])
                    return self.of_kind(schema, kind)
                inner = schema.get("additionalProperties")
                if isinstance(inner, dict):
                    return {"n1": self.of_schema(inner, key, sizes)}
                return {}
            case _:
                return self.word(key)

    def of_kind(self, schema: dict, kind: str) -> dict:
        """A table whose key `kind` says what it is."""
        for one in schema["allOf"]:
            if one["if"]["properties"]["kind"]["const"] == kind:
                return self.table(one["then"]["$ref"].split("/")[-1])
        raise KeyError(kind)

    def word(self, key: str) -> str:
        """A name of something that this machine has, or may not have."""
        words = {"file": "no_file.csv", "of": self.any.choice([*self.pistons, "piston"]), "takes_from": "1.head"}
        return words.get(key) or self.any.choice([*self.links, *self.pistons, "crank", "main", "O", "motor", "nothing"])

    def table(self, name: str, *, part: float = 0.25, leave: tuple[str, ...] = (), must: tuple[str, ...] = ()) -> dict:
        """A table with all that it must say, and a part of what it may."""
        schema, sizes = SCHEMA["$defs"][name], {}
        required = {*schema.get("required", ()), *must}
        made = {}
        count = self.any.randint(2, 5)
        for key, one in schema["properties"].items():
            if key in leave or not (key in required or self.chance(part)):
                continue
            sizes[key] = count
            if one.get("type") == "array" and key not in (
                "chambers",
                "columns",
                "throws",
                "journals",
                "bearings",
                "near",
            ):
                made[key] = [self.of_schema(one["items"], key, sizes) for _ in range(count)]
                if key in _SORTED:
                    made[key] = ascending(made[key])
            else:
                made[key] = self.of_schema(one, key, sizes)
        return made


def ascending(values: list) -> list:
    """Quantities of one unit in their order."""
    return sorted(values, key=lambda text: float(str(text).split()[0]))


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


MOTORS = {"cage": "Cage", "wound_rotor": "WoundRotor", "circuit": "Circuit", "shunt": "Shunt", "series": "Series", "servo": "Servo", "table": "Table", "prime_mover": "PrimeMover"}  # fmt: skip


def motor(make: Maker, ratio: float) -> dict:
    """A motor of a size that may drive the machine."""
    any_ = make.any
    kind = any_.choice(list(MOTORS))
    at_motor = Maker(any_.randrange(1 << 30))
    at_motor.size, at_motor.speed = make.size, make.speed * ratio
    at_motor.scales = make.scales | {
        "torque": make.scales["torque"] / ratio * 3, "speed": make.speed * ratio, "inertia": make.scales["inertia"] / ratio**2,
        "flywheel-moment": make.scales["flywheel-moment"] / ratio**2,
    }  # fmt: skip
    speed = make.speed * ratio * any_.uniform(0.9, 1.1)
    torque = at_motor.near("torque")

    def own(**values: tuple[float, str]) -> dict:
        return {name: make.text(value, dimension) for name, (value, dimension) in values.items()}

    base = own(inertia=(at_motor.near("inertia"), "inertia")) if make.chance(0.7) else {}
    rated = (
        own(torque=(torque, "torque"), speed=(speed, "speed"))
        if make.chance(0.6)
        else own(power=(torque * speed, "power"), speed=(speed, "speed"))
    )
    match kind:
        case "cage":
            made = rated | any_.choice(
                ({}, {"breakdown_ratio": 2.5}, {"breakdown_ratio": 2.3, "starting_ratio": 1.7, "curve": "catalogue"})
            )
            made |= own(synchronous_speed=(speed * any_.uniform(1.01, 1.2), "speed"))
            if make.chance(0.3):
                starter = any_.choice(("inverter", "soft_start", "star_delta", "direct"))
                made["starter"] = starter_of(make, starter)
        case "wound_rotor":
            made = rated | {"breakdown_ratio": 2.3} | own(synchronous_speed=(speed * 1.05, "speed"))
            if make.chance(0.3):
                made["rheostat"] = at_motor.table("Rheostat", part=0.5)
        case "circuit":
            made = {"synchronous_speed": make.text(speed * 1.05, "speed"), "phase_voltage": "230 V"}
            made |= {
                name: make.quantity("resistance-above-0")
                for name in ("stator_resistance", "rotor_resistance", "reactance")
            }
        case "shunt":
            made = rated | own(no_load_speed=(speed * any_.uniform(1.02, 1.2), "speed"))
        case "series":
            made = rated | {"voltage": "440 V"} | own(rated_current=(torque * speed / 440 * 1.2, "current"))
        case "servo":
            made = rated | own(peak_torque=(torque * any_.uniform(1, 4), "torque"))
            if make.chance(0.5):
                made |= own(top_speed=(speed * any_.uniform(1, 3), "speed"))
        case "table":
            made = {"speeds": [make.text(speed * at, "speed") for at in (0.0, 0.5, 0.9, 1.05)]}
            made["torques"] = [make.text(torque * at, "torque") for at in (1.5, 1.8, 2.0, 0.0)]
        case _:
            made = rated | own(no_load_speed=(speed * 1.1, "speed"))
            made["full_load"] = {
                "speeds": [make.text(speed * at, "speed") for at in (0.0, 0.5, 1.05)],
                "torques": [make.text(torque * at, "torque") for at in (0.0, 1.1, 1.0)],
            }
    extra = at_motor.table(MOTORS[kind], part=0.15, leave=("starter", "rheostat")) if make.chance(0.15) else {}
    return {"kind": kind, **{k: v for k, v in extra.items() if k not in made}, **base, **made}


def starter_of(make: Maker, kind: str) -> dict:
    """What starts a cage motor."""
    schema = SCHEMA["$defs"]["Cage"]["properties"]["starter"]
    kinds = schema["properties"]["kind"]["enum"]
    return make.of_kind(schema, kind if kind in kinds else make.any.choice(kinds))


def drive(make: Maker) -> dict:
    """Motor, stages, clutch and brake, with what is asked of them."""
    any_ = make.any
    found: dict = {}
    n_stages = any_.choice((0, 1, 1, 2, 3))
    one = any_.choice((0.5, 2.0, 8.0, 40.0)) ** (1 / max(n_stages, 1))
    found["stage"] = [
        {"ratio": round(one, 3), **make.table("Stage", part=0.2, leave=("ratio", "lead_angle", "friction_angle"))}
        for _ in range(n_stages)
    ]
    if n_stages and make.chance(0.15):
        worm = {
            "ratio": round(one, 3),
            "kind": "worm",
            "lead_angle": "10 deg",
            "friction_angle": any_.choice(("3 deg", "9 deg", "12 deg")),
        }
        found["stage"][any_.randrange(n_stages)] = worm
    if not found["stage"]:
        del found["stage"]
    if make.chance(0.85):
        found["motor"] = motor(make, one**n_stages)
    where = ["motor", "crank", *range(1, n_stages + 1)]
    if make.chance(0.4):
        found["part"] = {
            "fly": {
                "on": any_.choice([w for w in where if w != "crank"] or ["motor"]),
                "inertia": make.quantity("inertia-from-0"),
            }
        }
    if make.chance(0.25):
        found["clutch"] = {
            "on": any_.choice([w for w in where if w != "crank"]),
            **make.table("Clutch", part=0.4, leave=("on",)),
        }
    if make.chance(0.3):
        found["brake"] = make.table("Brake", part=0.4, leave=("on",)) | {
            "on": any_.choice(("motor", "clutch", "crank"))
        }
    if "clutch" in found and make.chance(0.8):
        found["stroke"] = make.table("Stroke", part=0.4)
    for key, name, part in (("start", "Start", 0.4), ("duty", "Duty", 0.4), ("flywheel", "SizedFlywheel", 0.3)):
        if make.chance(part):
            found[key] = make.table(name, part=0.25, leave=("on", "interval", "tolerance"))
    if "flywheel" in found:
        found["flywheel"]["on"] = any_.choice(where)
    if "start" in found and make.chance(0.8):
        found["start"]["duration"] = make.text(20 / make.speed, "time")
    return found


def wanted_motion(make: Maker) -> dict:
    """A motion of the piston that a servo motor is to make."""
    any_, travel = make.any, 2 * make.size * make.any.choice((1.0, 0.9, 0.5, 1.0, 1.02))
    base = {"of": make.pistons[0]} if make.chance(0.5) else {}
    period = 6 / make.speed
    if make.chance(0.4):
        n = any_.choice((4, 8, 14))
        base["times"] = [f"{float(f'{period * i / n:.6g}')!r} s" for i in range(n)]
        base["positions"] = [make.text(travel * (1 - math.cos(math.tau * i / n)) / 2, "length") for i in range(n)]
        return base | {"period": make.text(period, "time")}
    pieces = [
        {"duration": make.text(period / 3, "time"), "to": make.text(travel * at, "length")}
        for at in (any_.choice((1.0, 0.8)), 0.0)
    ]
    if make.chance(0.4):
        pieces.insert(1, {"duration": make.text(period / 4, "time")})
    if make.chance(0.4):
        pieces[0]["law"] = any_.choice(SCHEMA["$defs"]["MotionPiece"]["properties"]["law"]["enum"])
    if make.chance(0.4):
        base["counts_from"] = any_.choice(("far", "near"))
    return base | {"piece": pieces}


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
        "masses": (0.7, masses), "crankshaft": (0.3, crankshaft), "torsion": (0.15, torsion), "drive": (1.0 if is_driven else 0.0, drive),
        "evenness": (0.25, lambda m: m.table("Evenness", part=0.4)), "balance": (0.12, lambda m: m.table("Balance", part=0.4)),
        "friction": (0.12, lambda m: {m.any.choice([*m.links, "pins"]): m.quantity("ratio-from-0-below-1")}),
        "guide": (0.08, lambda m: {m.links[-1]: m.table("Guide", part=0.5)}),
    }  # fmt: skip
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


def toml(tables: dict) -> str:
    """Tables as a machine file."""
    return "\n".join(_lines(tables, ())) + "\n"


def _lines(table: dict, path: tuple[str, ...]):
    if path:
        yield f"[{'.'.join(path)}]"
    inner = {}
    for key, value in table.items():
        if isinstance(value, dict):
            inner[key] = value
        else:
            yield f"{key} = {_value(value)}"
    for key, value in inner.items():
        yield from _lines(value, (*path, key))


def _value(value) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_value(one)}" for key, one in value.items()) + " }"
    return repr(value)
