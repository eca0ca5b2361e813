"""`new` and `schema`: what a machine file starts from."""

from dataclasses import replace

from cranktrain.errors import InputError, Problem
from cranktrain.io.examples import example_called, example_near, example_text, plain_name
from cranktrain.io.output import write_machine_file, write_whole
from cranktrain.io.starting import starting_file
from cranktrain.language import said as _
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.kind import AnyKind
from cranktrain.quantities import unlisted


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


def _kind_called(name: str) -> AnyKind:
    """Find the kind of that name; capitals do not matter, nor `-` for `_`."""
    if plain_name(name) in KINDS.names:
        return KINDS.named(plain_name(name))
    wrong = unlisted("KIND", name, list(KINDS.names))
    near = None if wrong.repair is not None else example_near(name)
    repair = wrong.repair if near is None else _("or did you mean the example {name}?", name=near)
    raise InputError([replace(wrong, repair=repair)])
