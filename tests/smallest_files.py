"""Every command, and the smallest machine files: each table alone, and every example with a part taken out."""

import re
import tomllib
from collections.abc import Iterator
from importlib.resources import files

from cranktrain.cli.new import starting_file
from cranktrain.mechanisms import KINDS
from cranktrain.viz import PICTURES

MASSES = """
[masses.crank]
mass = "2 kg"
along = "12 mm"
inertia = "0.004 kg·m²"
"""
SIZES = """
journal_diameter = "60 mm"
pin_diameter = "55 mm"
pin_length = "35 mm"
web_thickness = "20 mm"
web_width = "80 mm"
bearing_distance = "120 mm"
"""
MOTOR = """
[drive.motor]
kind = "cage"
power = "4 kW"
speed = "1440 rpm"
synchronous_speed = "1500 rpm"
breakdown_ratio = 2.5
[[drive.stage]]
ratio = 5
"""
CLUTCH = """
[drive.part.flywheel]
on = 1
inertia = "2 kg·m²"
[drive.clutch]
on = 1
torque = "2 kN·m"
[drive.brake]
torque = "1 kN·m"
[drive.stroke]
start_angle = "0 deg"
"""
OWN = {
    "nothing": "",
    "load on the shaft": '[load.l]\non = "main"\ntorque = "5 N·m"\n',
    "load on the crank": '[load.l]\non = "crank"\ntorque = "5 N·m"\n',
    "empty drive": "[drive]\n",
    "load and empty drive": '[load.l]\non = "main"\ntorque = "5 N·m"\n[drive]\n',
    "motor alone": MOTOR,
    "clutch": MOTOR + CLUTCH,
    "duty": MOTOR + "[drive.duty]\n",
    "start": MOTOR + '[drive.start]\nduration = "1 s"\n',
    "crankshaft": f"[crankshaft]\n{SIZES}",
    "load and crankshaft": f'[crankshaft]\n{SIZES}[load.l]\non = "main"\ntorque = "5 N·m"\n',
    "gravity": "",
    "evenness": '[evenness]\nflywheel = "1 kg·m²"\n',
    "friction": "[friction]\npins = 0.01\n",
}
"""Tables that stand alone after a mechanism; `gravity` is a key before it."""

_TABLE = re.compile(r"^\[\[?([\w.]+)\]?\]", re.MULTILINE)


def without_marks(text: str) -> str:
    """A file whose optional keys and tables have lost their comment marks."""
    return re.sub(r"^# (?=\[|[\w.]+ = )", "", text, flags=re.MULTILINE)


def tables_of(text: str) -> list[tuple[str, str]]:
    """The tables of a file in their order, each by its name with what stands in it; first what stands before all."""
    starts = [*_TABLE.finditer(text)]
    ends = [*(one.start() for one in starts), len(text)]
    return [("", text[: ends[0]])] + [
        (one[1], text[one.start() : end]) for one, end in zip(starts, ends[1:], strict=True)
    ]


def smallest_files() -> dict[str, str]:
    """Machine files by name: of each kind every table of its starting file alone, and those above."""
    found = {}
    for kind in KINDS:
        base, tables = _taken_apart(without_marks(starting_file(kind, full=True)))
        plain = "\n".join(
            line for line in base.splitlines() if not line.startswith(("gravity", "crank_zero", "running"))
        )
        for name, text in [*OWN.items(), *tables.items()]:
            before = f"gravity = true\n{plain}" if name == "gravity" else plain
            found[f"{kind.name}: {name}"] = f"{before}\n{text}"
            if not name.startswith("masses"):
                found[f"{kind.name}: {name}, with mass"] = f"{before}\n{MASSES}{text}"
    for name in list(found)[:: len(found) // 12]:
        found[f"{name}, without a speed"] = re.sub(r"(?m)^\[shaft\.main\]\nspeed.*\n", "", found[name])
    return found


def _taken_apart(text: str) -> tuple[str, dict[str, str]]:
    """What every machine has, name, shaft and mechanism; and each other table with those below it, by its name."""
    base, tables = "", {}
    for name, part in tables_of(text):
        head = name.split(".")[0]
        if head in ("", "shaft", "mechanism", "bank"):
            base += part
        else:
            tables[head] = tables.get(head, "") + part
    return base, tables


def commands() -> dict[str, tuple[str, ...]]:
    """What may be typed of a machine file, which is `FILE`; outputs are called `out`."""
    found = {
        " ".join(one): one
        for one in (
            ("check", "FILE"),
            ("run", "FILE"),
            ("run", "FILE", "--full"),
            ("run", "FILE", "--inputs", "--checks", "--missing"),
            ("run", "FILE", "--partial", "--step", "30"),
            ("run", "FILE", "--running-speed"),
            *(("run", "FILE", "--step", "30", "-o", f"out.{form}") for form in ("csv", "json", "xlsx")),
            ("run", "FILE", "-o", "out.csv", "--facts"),
            ("start", "FILE", "--full"),
            *(("start", "FILE", "-o", f"out.{form}") for form in ("csv", "json", "svg")),
            ("textbook", "FILE", "--table"),
            ("textbook", "FILE", "--forces", "N"),
            ("textbook", "FILE", "--forces", "bar"),
            ("textbook", "FILE", "--harmonics"),
            ("textbook", "--drive", "FILE"),
            ("textbook", "--throw", "FILE"),
            ("compare", "FILE", "FILE"),
            ("compare", "FILE", "--set", "shaft.main.speed=50 rpm"),
            ("plot", "FILE", "-o", "out.gif"),
            ("view", "FILE", "-o", "out.html"),
            ("plot", "FILE", "-o", "out.dxf"),
            *(
                ("plot", "FILE", f"--{one.kind}", one.name, "-o", "out.svg")
                for one in PICTURES
                if one.kind in ("sheet", "plan")
            ),
        )
    }
    return {name: (*one, "--force") if "-o" in one else one for name, one in found.items()}


def examples_taken_apart() -> Iterator[tuple[str, dict]]:
    """Every example without one of its tables, or one that stands in these; but for what makes it a machine."""
    for path in sorted(files("cranktrain.examples").iterdir(), key=lambda one: one.name):
        if path.name.endswith(".toml"):
            tables = tomllib.loads(path.read_text(encoding="utf-8"))
            for place in _places(tables):
                yield f"{path.name} without {'.'.join(place)}", _without(tables, place)


def _places(tables: dict) -> Iterator[tuple[str, ...]]:
    for name, table in tables.items():
        if name in ("name", "rotation", "mechanism", "bank"):
            continue
        if name != "shaft":
            yield (name,)
        if isinstance(table, dict):
            for key, value in table.items():
                if isinstance(value, dict) and name == "shaft":
                    yield from ((name, key, inner) for inner in value if inner != "throws")
                else:
                    yield name, key


def _without(tables: dict, place: tuple[str, ...]) -> dict:
    key, *rest = place
    if rest:
        return tables | {key: _without(tables[key], tuple(rest))}
    return {name: value for name, value in tables.items() if name != key}
