"""The ruler over the curves of motion: triangles at the dead centres, with their angles and whose they are."""

from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.viz.panel import Role
from cranktrain.viz.paper.page import MARGIN, Page
from cranktrain.viz.paper.panels import PENS
from cranktrain.viz.paper.style import INK
from cranktrain.viz.sheets.motion.dead_centres import FEW, SHORT, Mark, Ruler


def draw_ruler(page: Page, ruler: Ruler, left: float, right: float, top: float) -> float:
    """Draw the true dead centres over the curves; give where the ruler ends. [mm]"""
    page.heading(left, top - 3.0, ruler.heading)
    if not ruler.marks:
        return top - 5.0
    y = top - 9.0
    _legend(page, ruler, right, top - 3.0)
    if ruler.has_legend and ruler.is_few and ruler.textbook:
        y -= 5.0
    has_samples = bool(ruler.pistons) and ruler.is_few and not ruler.is_of_cylinders
    rows = grouped((mark.name if ruler.is_few else mark.word, mark) for mark in ruler.marks)
    for number, (row, marks) in enumerate(rows.items()):
        page.rule(y, left, right)
        if ruler.pistons and len(row) <= SHORT + 2:
            start = left - (14.0 if has_samples else 2.0)
            page.text(start, y - 1.0, row, ha="left" if has_samples else "right", fontweight="bold")
        if has_samples:
            _sample(page, "second" if number else "first", left - 8.5, left - 2.0, y)
        for mark in marks:
            x = left + (right - left) * (mark.angle % 360.0) / 360.0
            _mark(page, ruler, mark, (x, y), right)
        y -= 5.5 if ruler.is_few else 11.5
    return y


def _sample(page: Page, role: Role, start: float, end: float, y: float) -> None:
    """Draw a sample of a curve's line, of a second one with a ring."""
    page.sample(start, end, y, color=INK, lw=PENS[role].width)
    if role == "second":
        page.paper.plot([(start + end) / 2], [y], "o", ms=3.2, mfc="white", mec=INK, mew=0.8)


def _legend(page: Page, ruler: Ruler, right: float, y: float) -> None:
    """Say what the habits of lines are that no ruler shows."""
    if ruler.textbook:
        start, _end = page.ends(page.text(right, y, _("textbook: {forms}").format(forms=ruler.textbook), ha="right"))
        page.sample(
            start - 9.0, start - 1.5, y + 0.9, color=INK, lw=PENS["textbook"].width, dashes=PENS["textbook"].dashes
        )
        right = start - 13.0
    if not ruler.has_legend:
        return
    is_many = len(ruler.pistons) > FEW
    words = [ruler.pistons[0], f"{ruler.pistons[1]}–{ruler.pistons[-1]}"] if is_many else ruler.pistons
    roles: tuple[Role, Role] = ("first", "other" if is_many else "second")
    if ruler.textbook and not is_many:  # there is no room beside it
        right, y = page.width - MARGIN, y - 5.0
    for number in reversed(range(len(words))):
        start, _end = page.ends(page.text(right, y, words[number], ha="right"))
        _sample(page, roles[number], start - 8.0, start - 1.5, y + 0.9)
        right = start - 11.0


def _mark(page: Page, ruler: Ruler, mark: Mark, place: tuple[float, float], right: float) -> None:
    """Draw one dead centre: a triangle, filled for the first piston, with its angle beside or below it."""
    x, y = place
    fill = INK if mark.name == ruler.names[0] else "white"
    page.paper.plot([x], [y], "v" if mark.is_top else "^", ms=4.5, mfc=fill, mec=INK, mew=0.7, zorder=6)
    if ruler.is_few:
        is_last = x > right - 26.0
        words = f"{mark.word} {mark.angle:.2f}°"
        page.text(x + (-2.0 if is_last else 2.0), y + 0.8, words, ha="right" if is_last else "left")
    else:
        page.text(x, y - 1.6, f"{mark.name}\n{mark.angle:.1f}", ha="center", va="top", linespacing=1.05)
