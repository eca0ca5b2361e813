"""What a machine file starts from: one mechanism of a kind, and the tables that suit it."""

from cranktrain.language import N_
from cranktrain.language import said as _
from cranktrain.mechanisms.kind import AnyKind
from cranktrain.saying.comments import with_said_comments

_SCHEMA_FILE = "cranktrain.schema.json"

_HEAD = N_("""\
#:schema ./{schema}
# For editors that complete as you type: cranktrain schema -o {schema}
# What the machine does: cranktrain run FILE; what is still missing: cranktrain check FILE
# A quantity is text with its unit; it can say where it is from:
# {{ value = "90 mm", status = "published", note = "…", source = "…" }}; or derived, assumed, fitted
""")

_MARKS = N_("""\
# What stands behind a comment mark, `# key = …` or `# [table]` with its keys, works when the mark is taken away.
""")

_MACHINE = N_("""
name = "My machine"              # {title}
rotation = "clockwise"            # or "anticlockwise", as seen from the free end of the shaft
# running = "astern"              # against that sense
""")

_GRAVITY = N_("""\
# gravity = true                  # weights count, downward
# crank_zero = "Y"                # angles count from where the crank points up
""")

_SHAFT = N_("""
[shaft.main]
{speed:33} # with it: velocities and accelerations
""")


def starting_file(kind: AnyKind, *, full: bool = False) -> str:
    """Give a machine file with one mechanism of a kind, commented, that works as it is.

    With `full` every table that suits the kind stands in it behind comment marks, and works without these.
    """
    tables = "" if kind.tables is None else kind.tables.read_text(encoding="utf-8")
    if not full:
        tables = tables.partition("\n# [")[0].rstrip("\n") + "\n"
    return "".join(
        (
            _(_HEAD, schema=_SCHEMA_FILE),
            _(_MARKS) if full else "",
            _(_MACHINE, title=_(kind.title)),
            _(_GRAVITY) if full else "",
            _(_SHAFT, speed=f'speed = "{kind.speed}"'),
            f"\n{with_said_comments(kind.example)}",
            with_said_comments(tables) if tables.strip() else "",
        )
    )
