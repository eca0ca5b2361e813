"""A run as a file, by how its name ends: for every command alike."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import PurePath

from cranktrain.cli.asked import decimal_problems
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.extras import lacking_for
from cranktrain.io.output import write_whole
from cranktrain.io.writers import SUFFIXES, Form, written
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.saying.run import Run


def form_or_picture(
    output: str, decimal: str = "point", others: Sequence[str] = (), *, facts: bool = False
) -> Form | None:
    """How a run is to be written into a file; None of a picture, or of one of `others`; as `form_of`."""
    from cranktrain.viz.output import FORMATS  # only where something is written

    return form_of(output, decimal, (*others, *FORMATS), facts=facts)


def form_of(output: str, decimal: str = "point", others: Sequence[str] = (), *, facts: bool = False) -> Form | None:
    """How a run is to be written into a file; None where its name ends in one of `others`, of which else is known.

    Raises
    ------
    InputError
        Where the name ends in nothing that is known, the form has no place for what is asked, or a package that the
        file needs is not installed.
    """
    refuse(decimal_problems(decimal))
    suffix = PurePath(output).suffix.lower()
    if suffix in others:
        refuse(lacking_for(suffix))
        return None
    if suffix not in SUFFIXES:
        allowed = _("must end in one of: {suffixes}", suffixes=", ".join((*SUFFIXES, *others)))
        raise InputError([Problem("-o", output, allowed)])
    form = Form(suffix, decimal, facts)
    refuse(form.problems())
    return form


def texts_of(make: Callable[[], Run]) -> dict[str, Callable[[], Iterable[str | bytes]]]:
    """What makes a run and files of all of it, by their suffixes; tables of a text's statements are its own."""

    def pieces(suffix: str) -> Iterable[str | bytes]:
        run = make()
        return written(Form(suffix), run, {}, tuple(run.catalogue), is_all=True)

    return {suffix: partial(pieces, suffix) for suffix in (".json", ".xlsx", ".nc")}


def write_run(run: Run, form: Form, output: str, machine: Mapping[str, object], *, force: bool) -> None:
    """Write all of a run, with the data of its machine's file where it is of one; say what was written."""
    write_whole(output, written(form, run, machine, tuple(run.catalogue), is_all=True), force=force)
    print(_("written: {name}", name=one_line(output)))
