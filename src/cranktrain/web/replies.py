"""From what a page asks to what it is sent: computed, or what is wrong, here and now."""

import traceback
from collections.abc import Callable

from cranktrain.errors import InputError
from cranktrain.language import _, in_language
from cranktrain.web.asked import HowFar, PageQuestion, Reply, SweepQuestion
from cranktrain.web.case import (
    export_of,
    file_text,
    packed_handles,
    packed_members,
    packed_others,
    packed_page,
    packed_tab,
    packed_trust,
    packed_whence,
)
from cranktrain.web.gallery import gallery
from cranktrain.web.packed import packed
from cranktrain.web.refusals import refusal_of, refused


def _unsaid(_how_far: HowFar) -> None:
    """Let nobody know how far an answer is."""


def reply_to(question: PageQuestion | SweepQuestion, say: Callable[[HowFar], None] = _unsaid) -> Reply:
    """Give what is asked for, or say what is wrong with the machine; whatever comes up, it is a reply.

    Parameters
    ----------
    question : PageQuestion or SweepQuestion
    say : callable
        Called when it is known how far a long one is.
    """
    with in_language(question.language):
        return _reply(question, say)


def _reply(question: PageQuestion | SweepQuestion, say: Callable[[HowFar], None]) -> Reply:
    """Give it in the language that is chosen."""
    try:
        if isinstance(question, SweepQuestion):
            from cranktrain.web.sweeping import packed_sweep  # pages ask for none

            return Reply(200, "application/octet-stream", packed_sweep(question, say).content)
        if question.part == "file" and question.case is not None:
            return Reply(
                200, "text/plain; charset=utf-8", file_text(question.case, question.key, question.part_added).encode()
            )
        return Reply(200, "application/octet-stream", _content(question))
    except InputError as error:
        return refused(error.problems)
    except (MemoryError, RecursionError):
        return refusal_of(422, _("asks for more than can be computed here"))
    except Exception:  # a fault of ours ends this question alone, and is seen where the service was started
        traceback.print_exc()
        return refusal_of(500, _("could not be computed: a fault of cranktrain, which the service's terminal shows"))


def _content(question: PageQuestion) -> bytes:
    """Compute a part of a page as its bytes."""
    case, part, tab, beside, key, piston, *_others = question
    if case is None:
        return packed(gallery()).content
    if part == "export":
        return export_of(case, tab, key)
    if part == "whence":
        return packed_whence(case, key).content
    if part == "page":
        return packed_page(case, tab, beside, piston).content
    if part == "tab":
        return packed_tab(case, tab, beside, piston).content
    if part == "others":
        return packed_others(case, tab, beside, piston).content
    if part == "members":
        return packed_members(case, piston).content
    return (packed_trust(case) if part == "trust" else packed_handles(case, piston)).content
