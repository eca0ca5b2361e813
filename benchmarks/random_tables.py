"""Random tables of machine files: mostly possible, at any size, now and then at a border or beyond it.

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
    "length": "m",
    "mass": "kg",
    "angle": "rad",
    "speed": "rad/s",
    "torque": "N·m",
    "force": "N",
    "power": "W",
    "time": "s",
    "inertia": "kg·m²",
    "flywheel-moment": "kg·m²",
    "pressure": "Pa",
    "temperature": "K",
    "velocity": "m/s",
    "frequency": "Hz",
    "density": "kg/m³",
    "stiffness": "N/m",
    "torsional-stiffness": "N·m/rad",
    "current": "A",
    "voltage": "V",
    "resistance": "Ω",
    "energy": "J",
    "acceleration": "m/s²",
    "angular-acceleration": "rad/s²",
    "heat-transfer": "W/m²/K",
    "bending-stiffness": "N·m²",
    "frequency-of-vibration": "Hz",
    "molar-mass": "kg/mol",
    "ratio": "",
}


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
            "length": self.size,
            "mass": mass,
            "angle": 1.0,
            "speed": self.speed,
            "torque": torque,
            "force": force,
            "power": torque * self.speed,
            "time": 5 / self.speed,
            "inertia": mass * self.size**2,
            "flywheel-moment": 4 * mass * self.size**2,
            "pressure": pressure,
            "temperature": 300.0,
            "velocity": self.size * self.speed,
            "frequency": self.speed / 6,
            "density": 7850.0,
            "stiffness": 1e9 * self.size,
            "torsional-stiffness": 1e8 * self.size**3,
            "current": torque * self.speed / 400,
            "voltage": 400.0,
            "resistance": 400.0**2 / max(torque * self.speed, 1e-12),
            "energy": pressure * self.size**3,
            "acceleration": 9.81,
            "angular-acceleration": self.speed**2,
            "heat-transfer": 500.0,
            "bending-stiffness": 1e9 * self.size**4,
            "frequency-of-vibration": 10 * self.speed,
            "molar-mass": 0.029,
            "ratio": 1.0,
        }
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
                count = sizes.setdefault(key, self.any.randint(1, 4))
                return [self.of_schema(schema["items"], key, sizes) for _ in range(count)]
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
