"""The table [torsion] of the machine file: discs that turn with the crankshaft, and the shafts between them."""

import re
from collections.abc import Iterator, Mapping
from typing import Annotated, Literal

from pydantic import Field

from cranktrain.allowed import Name
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.listed import OneOrMany
from cranktrain.paths import path_text
from cranktrain.quantities import (
    Given,
    NonNegativeInertia,
    PositiveInertia,
    PositiveRatio,
    PositiveTorsionalStiffness,
    VibrationFrequency,
    nearest,
)
from cranktrain.questions.torsion.shafts import ShaftPieceSpec
from cranktrain.spec import Spec

_DIRECT = Given(1.0, "1")


class DiscSpec(ShaftPieceSpec, frozen=True):
    """A disc that turns with the crankshaft: flywheel, pulley, gear, propeller, rotor.

    A shaft of its `stiffness`, or of its `length` and `diameter`, joins it to the throw or the disc `beside` it;
    without one it sits on that rigidly. Both turn `ratio` times for one turn of what they are beside, through gears in
    between.
    """

    inertia: PositiveInertia = Field(description=N_("Moment of inertia of the disc about its own axis."))
    beside: Annotated[int, Field(ge=1)] | str = Field(
        description=N_("What it is next to: a throw, by its number, or another disc, by its name.")
    )
    ratio: PositiveRatio = Field(
        default=_DIRECT,
        description=N_("Turns of the disc and its shaft for one turn of what it is beside; 1 unless given."),
    )


class TorsionSpec(Spec, frozen=True):
    """The crankshaft as discs, one for each throw, with shafts between them, and the discs beside it."""

    stiffness: OneOrMany[PositiveTorsionalStiffness] | None = Field(
        default=None,
        description=N_(
            "Of the crankshaft between neighbouring throws: one value, or one for each gap; by its sizes unless given."
        ),
    )
    stiffness_method: Literal["frame", "frame_clamped", "carter", "ker_wilson", "zimanenko"] | None = Field(
        default=None,
        description=N_("By which method the sizes of [crankshaft] give it; a crank frame unless said otherwise."),
    )
    gap: Mapping[Name, ShaftPieceSpec] = Field(
        default={},
        description=N_(
            "Gaps between throws that are not as `stiffness` or the sizes say, by the number of the throw before them."
        ),
    )
    throw_inertia: OneOrMany[NonNegativeInertia] | None = Field(
        default=None,
        description=N_("What turns with a throw and is not in [masses]: one moment of inertia, or one for each throw."),
    )
    disc: Mapping[Name, DiscSpec] = Field(
        default={},
        description=N_("Discs beside the throws, by name, in the order in which they stand along the shaft."),
    )
    holzer_at: OneOrMany[VibrationFrequency] | None = Field(
        default=None,
        description=N_("Frequency at which Holzer's table is asked for beside the natural ones, or a list of some."),
    )
    free_end: str | None = Field(
        default=None,
        description=N_("The disc at the free end whose amplitude is 1 in every mode; throw 1 unless given."),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find names that cannot be written, discs beside nothing, and a free end that does not move by itself."""
        if self.stiffness is not None and self.stiffness_method is not None:
            allowed = _("is for a stiffness by the sizes of [crankshaft]; here `stiffness` gives it")
            yield Problem("stiffness_method", self.stiffness_method, allowed, _("keep one of the two"))
        allowed = _("must have a name of letters, digits and _, a letter first")
        for name in self.disc:
            if not re.fullmatch(r"[^\W\d]\w*", name):
                yield Problem(path_text(("disc", name)), None, allowed)
        yield from self._neighbours()
        if self.free_end is not None and (self.free_end not in self.disc or not self.disc[self.free_end].is_elastic):
            elastic = [name for name, disc in self.disc.items() if disc.is_elastic]
            allowed = _("must be the name of a disc with a stiffness: {discs}", discs=", ".join(elastic))
            if not elastic:
                allowed = _("must be left out: no disc has a stiffness, and throw 1 is the free end")
            yield Problem("free_end", self.free_end, allowed)

    def _neighbours(self) -> Iterator[Problem]:
        for name, disc in self.disc.items():
            path = path_text(("disc", name, "beside"))
            if isinstance(disc.beside, str) and disc.beside not in self.disc:
                others = [other for other in self.disc if other != name]
                allowed = _("must be the number of a throw, or the name of another disc: {discs}")
                if not others:
                    allowed = _("must be the number of a throw; there is no other disc")
                meant = nearest(disc.beside, others)
                repair = _('write "{text}"', text=meant) if meant else None
                yield Problem(path, f'"{disc.beside}"', allowed.format(discs=", ".join(others)), repair)
            elif self._leads_to_itself(name):
                allowed = _("must lead to a throw; these discs stand in a ring, beside one another alone")
                yield Problem(path, f'"{disc.beside}"', allowed)

    def _leads_to_itself(self, name: str) -> bool:
        at: int | str = name
        for _step in self.disc:
            at = self.disc[at].beside if isinstance(at, str) and at in self.disc else at
            if at == name:
                return True
        return False
