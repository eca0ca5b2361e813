"""Random motors with their gearing, clutch and brake, and wanted motions."""

import math

from random_tables import SCHEMA, Maker

MOTORS = {
    "cage": "Cage",
    "wound_rotor": "WoundRotor",
    "circuit": "Circuit",
    "shunt": "Shunt",
    "series": "Series",
    "servo": "Servo",
    "table": "Table",
    "prime_mover": "PrimeMover",
}


def motor(make: Maker, ratio: float) -> dict:
    """A motor of a size that may drive the machine."""
    any_ = make.any
    kind = any_.choice(list(MOTORS))
    at_motor = Maker(any_.randrange(1 << 30))
    at_motor.size, at_motor.speed = make.size, make.speed * ratio
    at_motor.scales = make.scales | {
        "torque": make.scales["torque"] / ratio * 3,
        "speed": make.speed * ratio,
        "inertia": make.scales["inertia"] / ratio**2,
        "flywheel-moment": make.scales["flywheel-moment"] / ratio**2,
    }
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
