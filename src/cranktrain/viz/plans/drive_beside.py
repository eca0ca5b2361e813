"""The drive beside a scheme: its chain below the mechanism, its table below that of the letters."""

from collections.abc import Sequence

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.plans.drive_scheme import DriveShaft
from cranktrain.plans.together import places_called
from cranktrain.viz.paper.page import LINE, Box, Page
from cranktrain.viz.paper.tables import ROW, write_row
from cranktrain.viz.plans.drive_chain import DrawnPart, bounds_of_chain, chain_drawing, draw_chain
from cranktrain.viz.plans.drive_table import drive_rows, meanings, with_indices

_HEAD = 7.0
"""Height of the heading, with what is free below it. [mm]"""
_LEAST_ROW = 3.5
"""Below which rows of text touch. [mm]"""


class DriveBeside:
    """A drive's chain and table, made for rooms of given widths. [mm]"""

    def __init__(
        self, chain: Sequence[DriveShaft], shaft_letter: str, widths: tuple[float, float], *, has_motion: bool
    ) -> None:
        drawn, written = widths
        has_speed = bool(np.isfinite(chain[-1].speed))
        self.heading = _("Drive, at the declared speed of the crank") if has_speed else _("Drive")
        self.parts: list[DrawnPart] = chain_drawing(chain, drawn, shaft_letter)
        self.rows = drive_rows(chain, shaft_letter, written)
        self.notes = meanings(chain, written)
        if has_motion:
            self.notes.append(_("The crank moves as [shaft.main.motion] says, not at one speed."))

    @property
    def height(self) -> float:
        """Of the chain, with what is free above it. [mm]"""
        low, high = bounds_of_chain(self.parts)
        return float(high[1] - low[1]) + 6.0

    def row_height(self, n_others: int, room: float) -> float:
        """Height of rows with those of another table, in a room so high [mm].

        Raises
        ------
        InputError
            If there are too many for the sheet.
        """
        free = room - 3 * _HEAD - LINE * len(self.notes)
        height = free / (len(self.rows) + n_others)
        if height < _LEAST_ROW:
            most = int(free / _LEAST_ROW) - n_others
            allowed = _("must have at most {most} rows of the drive's table on this sheet", most=most)
            raise InputError([Problem("", _("{n} rows", n=len(self.rows)), allowed, _("take size A3"))])
        return min(ROW, height)

    def draw(self, page: Page, box: Box) -> None:
        """Draw the chain at the foot of a room."""
        draw_chain(page, self.parts, box._replace(height=self.height - 6.0))

    def write(self, page: Page, box: Box, top: float, line: float) -> None:
        """Write the table from a height on, and what its letters stand for. [mm]"""
        page.heading(box.left, top - 3.0, self.heading)
        page.rule(top - 4.6, box.left, box.left + box.width)
        places = ((box.left, "left"), (box.left + box.width, "right"))
        y = top - 4.6 - line
        for row in self.rows:
            write_row(page, row.cells_set, places, y, is_bold=row.is_shaft)
            y -= line
        page.notes(box.left, y - 0.5, list(map(with_indices, self.notes)))


def crank_pin(machine: Machine, mechanism: str | None) -> str | None:
    """Pin at which the crank's shaft of a drive, `main`, is drawn; None where what is drawn is on others alone."""
    shafts = [place.shaft for place in places_called(machine, mechanism)]
    if "main" not in shafts:
        return None
    place = shafts.index("main")
    return "O" if place == 0 else f"O{place + 1}"
