"""How machines and results show themselves: in one line where they are typed, with the answer in a notebook."""

from collections.abc import Iterable, Iterator
from html import escape

from cranktrain.analysis.designs_summary import summary_of_designs
from cranktrain.analysis.fact_values import FactValues, OneMachine, fact_values, headline_names
from cranktrain.analysis.result import Result
from cranktrain.analysis.unused import sentences
from cranktrain.faces import face
from cranktrain.grouping import grouped
from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.one_line import one_line, short
from cranktrain.saying.row_words import row_lines
from cranktrain.saying.wording import all_of, as_given

_LONGEST_NAME, _FEW = 70, 3


def machine_line(machine: Machine) -> str:
    """Say in one line which machine it is."""
    return f"<Machine {short(machine.name, _LONGEST_NAME) or _('without a name')}: {_about(machine)}>"


def machine_html(machine: Machine) -> str:
    """Say which machine it is, and how to go on."""
    words = [_paragraph(_about(machine)), _paragraph(_("ct.run(machine) computes it; machine.with_({…}) changes it"))]
    return f"<b>{_name(machine)}</b>{''.join(words)}"


def result_line(result: Result) -> str:
    """Say in one line whose result it is, and how much it has."""
    name = short(result.machines[0].name, _LONGEST_NAME) or _("a machine without a name")
    if result.has_designs:
        name = _("{n} designs of {name}", n=len(result.machines), name=name)
    n_quantities = len(result.catalogue)
    held = _("1 quantity") if n_quantities == 1 else _("{n} quantities", n=n_quantities)
    if result.asked is not None:
        held = ", ".join(result.asked) if len(result.asked) <= _FEW else _("{n} quantities", n=len(result.asked))
    words = [held, *_trust(result)]
    return f"<Result of {name}: {', '.join(words)}>"


def result_lines(result: Result, design: int = 0) -> Iterator[str]:
    """Say of one design at which speed all is, where that varies, and the rows of the answer."""
    if (curve := result.get(SpeedCurve)) is not None:
        yield str(curve.condition(design))
    yield from row_lines(result.rows(design))


def result_html(result: Result) -> str:
    """Give the answer: what to mind, the facts that say most, and how far it can be trusted."""
    machine = result.machines[0]
    parts = [f"<b>{_name(machine)}</b>", _paragraph(_about(machine))]
    parts += [_paragraph(f"! {sentence}") for sentence in sentences(result.unused)]
    if flags := result.flags:
        flagged = _("! 1 flag") if len(flags) == 1 else _("! {n} flags", n=len(flags))
        parts.append(_folded(flagged, flags))
    if result.has_designs:
        parts.append(f"<ul>{''.join(f'<li>{escape(line)}</li>' for line in summary_of_designs(result))}</ul>")
    else:
        rows = fact_values([OneMachine(result)], headline_names([result]))
        parts += ["<table><tbody>", *_table(rows), "</tbody></table>"]
        parts.append(_folded(_("In words"), result_lines(result)))
        if worth_asking := result.worth_asking:
            lacking = (
                _("{needs}: gives {results}", needs=all_of(one.needs), results=", ".join(one.results))
                for one in worth_asking
            )
            parts.append(_folded(_("To learn more"), lacking))
    parts.append(_paragraph(" · ".join([*_trust(result), _("result.plot(), result.sheet(), result.dataset")])))
    return "".join(parts)


def _about(machine: Machine) -> str:
    """Say what a machine is and how fast it turns."""
    words: str = face("layout_words")(machine)
    speed = machine.main_shaft.speed
    return one_line(words if speed is None else f"{words}; {as_given(speed, 'rpm')}")


def _name(machine: Machine) -> str:
    return escape(one_line(machine.name)) or escape(_("Machine without a name"))


def _trust(result: Result) -> Iterator[str]:
    """Say how many checks hold, and do not, and of how much one is warned."""
    held = sum(bool(check.passed.all()) for check in result.checks)
    failed = sum(bool((check.judged & ~check.passed).any()) for check in result.checks)
    n_flags = len(result.flag_words) + len(sentences(result.unused))
    for n, one, more in (
        (held, _("1 check holds"), _("{n} checks hold")),
        (failed, _("1 check does not hold"), _("{n} checks do not hold")),
        (n_flags, _("1 flag"), _("{n} flags")),
    ):
        if n:
            yield one if n == 1 else more.format(n=n)


def _table(rows: Iterable[FactValues]) -> Iterator[str]:
    """Rows of a table, question by question."""
    for question, of_question in grouped((row.question, row) for row in rows).items():
        yield f'<tr><th colspan="3" style="text-align:left">{escape(_(question.capitalize()))}</th></tr>'
        for row in of_question:
            (text,), unit = row.texts
            cells = f"<td>{escape(text)}</td><td style='text-align:left'>{escape(unit)}</td>"
            yield f'<tr><td style="text-align:left">{escape(row.name)}</td>{cells}</tr>'


def _folded(head: str, sentences: Iterable[Words]) -> str:
    """Sentences that open below their head."""
    items = "".join(f"<li>{escape(str(sentence))}</li>" for sentence in sentences)
    return f"<details><summary>{escape(head)}</summary><ul>{items}</ul></details>"


def _paragraph(text: str) -> str:
    return f"<p style='margin:0.2em 0'>{escape(text)}</p>"
