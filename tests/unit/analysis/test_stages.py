"""Stages: their needs and outcomes are read from annotations; what is missing is said in words."""

from dataclasses import dataclass
from typing import ClassVar

import pytest
from tests.told import texts_of

from cranktrain.analysis import Stage, ordered
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.stages import lacking, leading_to, missing_results
from cranktrain.saying.catalogue import quantity


@dataclass(frozen=True)
class Bore:
    needs: ClassVar[str] = "[x] bore"
    value: float


@dataclass(frozen=True)
class Other:
    """What no machine file can say."""


@dataclass(frozen=True)
class Area:
    area: float = quantity("A", "m^2", (), "Area", "docs/conventions", "definition")


@dataclass(frozen=True)
class Force:
    force: float = quantity("F", "N", (), "Force", "docs/conventions", "definition")


@dataclass(frozen=True)
class Odd:
    odd: float = quantity("O", "1", (), "Odd", "docs/conventions", "definition")


def area(bore: Bore) -> Area:
    return Area(bore.value**2)


def force(area: Area, other: Other | None) -> Force:
    return Force(area.area * (1 if other is None else 2))


def odd(other: Other, area: Area) -> Odd:
    return Odd(0.0 * area.area)


STAGES = tuple(Stage(function) for function in (odd, force, area))


def ran(stages, parts):
    """What stages give, and what is missing for the others."""
    absent = lacking(stages, parts)
    return run_stages(stages, parts, absent), missing_results(stages, absent)


def test_annotations_are_needs_and_gift():
    read = Stage(force)
    assert read.needs == {"area": Area, "other": Other}
    assert read.optional == {"other"}
    assert read.gives is Force


def test_needs_come_before_their_use():
    assert [one.gives for one in ordered(STAGES)].index(Area) == 0


def test_gifts_in_the_order_of_the_declaration():
    outcomes, missing = ran(STAGES, {Bore: Bore(3.0), Other: Other()})
    assert list(outcomes) == [Odd, Force, Area]
    assert outcomes[Force].force == 18.0
    assert missing == ()


def test_an_optional_need_is_not_missed():
    outcomes, missing = ran(STAGES, {Bore: Bore(3.0)})
    assert outcomes[Force].force == 9.0
    assert Odd not in outcomes
    assert missing == ()  # no machine file can give what it lacks


def test_what_is_missing_is_traced_to_the_file():
    outcomes, missing = ran(STAGES, {Other: Other()})
    assert outcomes == {}
    (found,) = missing
    assert texts_of(found.needs) == ("[x] bore",)
    assert sorted(found.results) == ["area", "force", "odd"]


def test_division_by_zero_within_a_stage_is_nan_and_no_warning():
    import numpy as np

    def nothing(bore: Bore) -> Area:
        return Area(float(np.divide(0.0 * bore.value, 0.0)))

    outcomes, _missing = ran([Stage(nothing)], {Bore: Bore(1.0)})
    assert outcomes[Area].area != outcomes[Area].area


def test_stages_that_need_each_other_cannot_be_ordered():
    def first(force: Force) -> Area:
        return Area(force.force)

    def second(area: Area) -> Force:
        return Force(area.area)

    with pytest.raises(ValueError, match="cycle"):
        ordered((Stage(first), Stage(second)))


def test_what_is_beside_makes_no_stage_run():
    def both(area: Area | None, force: Force | None) -> Odd:
        return Odd(0.0 if force is None else force.force)

    stages = (Stage(area), Stage(force), Stage(both, beside=(Force,)))
    chosen = leading_to(stages, [Odd])
    assert [one.gives for one in chosen] == [Area, Odd]
    assert run_stages(chosen, {Bore: Bore(3.0)}, {})[Odd].odd == 0.0
    chosen = leading_to(stages, [Odd, Force])
    assert run_stages(chosen, {Bore: Bore(3.0)}, {})[Odd].odd == 9.0
