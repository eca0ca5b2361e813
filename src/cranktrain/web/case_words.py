"""Words of a page on which numbers may be changed: of what is on it whatever the machine."""

from functools import cache

from cranktrain.language import Words, _
from cranktrain.record import record


@record
class DesignWords:
    """Words of a page's tab on which numbers are varied."""

    title: Words
    varied: Words
    second: Words
    nothing: Words
    start: Words
    end: Words
    count: Words
    wanted: Words
    compute: Words
    cancel: Words
    hint: Words
    numbers: Words


@record
class AddingWords:
    """Words of parts that are added by clicks on the drawing."""

    add: Words
    back: Words
    cancel: Words
    cross: Words


@record
class CaseWords:
    """Words of a page on which numbers may be changed."""

    machine: Words
    numbers: Words
    undo: Words
    redo: Words
    save: Words
    as_in_file: Words
    compare: Words
    keep: Words
    gallery: Words
    open: Words
    export: Words
    more: Words
    unnamed: Words
    second: Words
    whence: Words
    stages: Words
    rests_on: Words
    close: Words
    design: DesignWords
    move: Words
    adding: AddingWords
    others: Words
    language: Words
    no_answer: Words


@cache
def case_words(*, adds_parts: bool = False) -> CaseWords:
    """Give them; `adds_parts`: whether parts may be added to the machine by clicks."""
    return CaseWords(
        machine=_("Machine"),
        numbers=_("Numbers of the file"),
        undo=_("Undo"),
        redo=_("Redo"),
        save=_("Save the machine file"),
        as_in_file=_("As in the file"),
        compare=_("Compare with"),
        keep=_("Compare with this"),
        gallery=_("All machines"),
        open=_("Open a file"),
        export=_("Take away"),
        more=_("Add to the file"),
        unnamed=_("is named nowhere in the machine file"),
        second=_("is a second machine file: open one at a time"),
        whence=_("Where it is from"),
        stages=_("Stages"),
        rests_on=_("What this rests on"),
        close=_("Close"),
        design=DesignWords(
            title=_("Design"),
            varied=_("Vary"),
            second=_("and"),
            nothing=_("nothing"),
            start=_("from"),
            end=_("to"),
            count=_("values"),
            wanted=_("Wanted"),
            compute=_("Compute"),
            cancel=_("Stop"),
            hint=_("Click a point to load its design; the present one is marked."),
            numbers=_("Numbers"),
        ),
        move=_("Move pins, add parts") if adds_parts else _("Move pins"),
        adding=AddingWords(
            add=_("Add"),
            back=_("Back"),
            cancel=_("Cancel"),
            cross=_("A cross on the drawing: arrow keys move it, with shift farther; Enter takes what is there"),
        ),
        others=_("More"),
        language=_("Language"),
        no_answer=_("the service does not answer"),
    )
