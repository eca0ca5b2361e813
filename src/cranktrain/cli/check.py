"""`check`: all that is wrong with a machine file, or what it allows to compute."""

from cranktrain.analysis import sentences
from cranktrain.analysis.stages import spoken
from cranktrain.cli.how_far import says_how_far
from cranktrain.io.machine_file import computed, read_machine
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.saying.catalogue import entries
from cranktrain.saying.wording import all_of


def show_check(source: str) -> None:
    """Say that nothing is wrong, which numbers are unlikely, what can be computed and what is missing.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    file = read_machine(source)
    with says_how_far():
        result = computed(file)
    print(_("{file}: nothing wrong", file=one_line(file.document.name)))
    for sentence in (*sentences(result.unused), *result.unlikely):
        print(f"! {one_line(str(sentence))}")
    groups = ", ".join(spoken(kind) for kind in result.computed.kinds if entries(kind))
    print(_("can compute {n} results: {groups}", n=len(result.catalogue), groups=groups))
    for missing in result.worth_asking:
        print(
            _(
                "missing for {results}: {needs}",
                results=", ".join(missing.results),
                needs=all_of(missing.needs),
            )
        )
