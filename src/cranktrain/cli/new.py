"""`new` and `schema`: what a machine file starts from."""

from dataclasses import replace

from cranktrain.errors import InputError, Problem
from cranktrain.io.examples import example_called, example_near, example_text, plain_name
from cranktrain.io.output import write_machine_file, write_whole
from cranktrain.language import N_
from cranktrain.language import said as _
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.kind import AnyKind
from cranktrain.quantities import unlisted
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


def write_new(kind: str, output: str | None, *, full: bool = False, force: bool) -> None:
    """Write a machine file to start from, of a kind or a copy of an example; to the standard output unless asked."""
    example = None if plain_name(kind) in KINDS.names else example_called(kind)
    if example is None:
        text = starting_file(_kind_called(kind), full=full)
    elif full:
        allowed = _("must be left out: example {name} is copied as it is", name=example)
        raise InputError([Problem("--full", None, allowed)])
    else:
        text = example_text(example)
    write_machine_file(output or "-", text, force=force)


def write_schema(output: str | None, *, force: bool) -> None:
    """Write the JSON schema of machine files, to the standard output unless a file is named."""
    from cranktrain.io.schema import schema_text

    write_whole(output or "-", schema_text(), force=force)


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


def _kind_called(name: str) -> AnyKind:
    """Find the kind of that name; capitals do not matter, nor `-` for `_`."""
    if plain_name(name) in KINDS.names:
        return KINDS.named(plain_name(name))
    wrong = unlisted("KIND", name, list(KINDS.names))
    near = None if wrong.repair is not None else example_near(name)
    repair = wrong.repair if near is None else _("or did you mean the example {name}?", name=near)
    raise InputError([replace(wrong, repair=repair)])
