"""`new` and `schema`: what a machine file starts from."""

from cranktrain.errors import InputError
from cranktrain.io.output import write_whole
from cranktrain.language import _
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.kind import AnyKind
from cranktrain.quantities import unlisted

_SCHEMA_FILE = "cranktrain.schema.json"

_HEAD = _("""\
#:schema ./{schema}
# For editors that complete as you type: cranktrain schema -o {schema}
# What the machine does: cranktrain run FILE; what is still missing: cranktrain check FILE
# A quantity is text with its unit; it can say where it is from:
# {{ value = "90 mm", status = "published", note = "…", source = "…" }}; or derived, assumed, fitted

name = "My machine"              # {title}
rotation = "clockwise"            # or "anticlockwise", as seen from the free end of the shaft
# running = "astern"              # against that sense

[shaft.main]
speed = "1500 rpm"                # with it: velocities and accelerations
""")

_CYLINDER = _("""
[cylinder]                        # with it: volumes
bore = "80 mm"
compression_ratio = 9.5           # of the first cylinder, over the true stroke
# cycle = "four-stroke"           # or "two-stroke"; with the firing order: when each cylinder fires
# firing_order = "{order}"
""")


def write_new(kind: str, output: str | None, *, force: bool) -> None:
    """Write a machine file to start from, to the standard output unless a file is named."""
    write_whole(output or "-", starting_file(_kind_called(kind)), force=force)


def write_schema(output: str | None, *, force: bool) -> None:
    """Write the JSON schema of machine files, to the standard output unless a file is named."""
    from cranktrain.io.schema import schema_text

    write_whole(output or "-", schema_text(), force=force)


def starting_file(kind: AnyKind) -> str:
    """Give a machine file with one mechanism of a kind, commented, that works as it is."""
    head = _HEAD.format(schema=_SCHEMA_FILE, title=_(kind.title))
    if kind.output != "slider" or not (kind.has_chambers or "[bank." in kind.example):
        return f"{head}\n{kind.example}"
    order = "1L-1R" if "[bank.L]" in kind.example else "1"
    return f"{head}\n{kind.example}{_CYLINDER.format(order=order)}"


def _kind_called(name: str) -> AnyKind:
    """Find the kind of that name; capitals do not matter, nor `-` for `_`."""
    plain = name.casefold().replace("-", "_")
    found = next((kind for kind in KINDS if kind.name == plain), None)
    if found is None:
        raise InputError([unlisted("KIND", name, [kind.name for kind in KINDS])])
    return found
