"""`check`: all that is wrong with a machine file, or what it allows to compute."""

import re

from cranktrain.analysis import sentences
from cranktrain.catalogue import entries
from cranktrain.io.machine_file import computed, read_machine
from cranktrain.language import _
from cranktrain.one_line import one_line


def show_check(source: str) -> None:
    """Say that nothing is wrong, which numbers are unlikely, what can be computed and what is missing.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    file = read_machine(source)
    result = computed(file)
    print(_("{file}: nothing wrong").format(file=one_line(file.document.name)))
    for sentence in (*sentences(result.unused), *result.unlikely):
        print(f"! {one_line(sentence)}")
    groups = ", ".join(
        # `DeadCentres` are dead centres.
        re.sub(r"(?<=[a-z])(?=[A-Z])", " ", type(outcome).__name__).lower()
        for outcome in result.outcomes
        if entries(type(outcome))
    )
    print(_("can compute {n} results: {groups}").format(n=len(result.catalogue), groups=groups))
    for missing in result.worth_asking:
        print(
            _("missing for {results}: {needs}").format(
                results=", ".join(missing.results), needs=_(" and ").join(missing.needs)
            )
        )
