"""Loads, and pulls, of several designs together: each may have a file of its own, with lists of its own length."""

from collections.abc import Iterator, Sequence

from cranktrain.columns import in_columns
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import _
from cranktrain.layout.design import Designs
from cranktrain.layout.load_tables import OF_LISTS, LoadSpec, LoadTables, with_lists
from cranktrain.number_table import held_text
from cranktrain.quantities import Given
from cranktrain.spec import SpecType


def tables_together(designs: Designs) -> LoadTables:
    """Give the loads of all designs, whose numbers are columns of them.

    Parameters
    ----------
    designs : Designs

    Returns
    -------
    mapping of str to mapping of str to LoadSpec

    Raises
    ------
    InputError
        Where nobody has read a file; where files of designs say other things than sizes over the same.
    """
    found: dict[str, dict[str, LoadSpec]] = {}
    for path, named in designs.together.loads.items():
        for name, spec in named.items():
            each = [design.loads[path][name] for design in designs.each]
            refuse(_problems(each, f"{path}.{name}"))
            is_read = spec.file is not None and len(each) > 1
            found.setdefault(path, {})[name] = in_columns(as_long(each, OF_LISTS)) if is_read else spec
    return found


def _problems(each: Sequence[LoadSpec], path: str) -> Iterator[Problem]:
    """Find files that nobody has read, or that say other things in other designs."""
    for spec in each:
        is_read = spec.file is None or spec.text is not None
        if is_read and spec.file is not None and _holds(spec) != _holds(each[0]):
            allowed = _("must hold the same in all designs: forces or torques, over the same")
            yield Problem(f"{path}.file", spec.file, allowed)
        yield from unread_problems(spec.file, spec.text, path=path)
        if not is_read:
            return


def unread_problems(file: str | None, text: str | None, *, path: str) -> Iterator[Problem]:
    """Find a file that nobody has read."""
    if file is not None:
        try:
            held_text(file, text)
        except InputError as error:
            yield from (Problem(f"{path}.file", one.given, one.allowed) for one in error.problems)


def _holds(spec: LoadSpec) -> tuple[bool, str | None]:
    """Whether its sizes are forces, and over what they are."""
    return spec.force is not None, None if spec.over is None else spec.over[0]


def as_long(each: Sequence[SpecType], names: Sequence[str]) -> Sequence[SpecType]:
    """Make lists of all designs as long as the longest: a last place may stand again, which says nothing new."""
    lists: dict[str, list[tuple[Given, ...] | None]] = {name: [getattr(one, name) for one in each] for name in names}
    longest = max(len(one) for of_name in lists.values() for one in of_name if one is not None)

    def longer(one: tuple[Given, ...] | None) -> tuple[Given, ...] | None:
        return None if one is None else (*one, *one[-1:] * (longest - len(one)))

    return [
        with_lists(spec, {name: longer(of_name[number]) for name, of_name in lists.items()})
        for number, spec in enumerate(each)
    ]
