"""Geometries as nested tuples: stacking, mirroring, changing one length, taking rows."""

import numpy as np
import pytest
from tests.machines import as_columns, scaled

from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.crank_rocker import CrankRocker
from cranktrain.mechanisms.kind import mirrored, named_part, rows
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.nested import leaves

ROD = ArticulatedRod(SliderCrank(1.0, 2.0, 3.0), 4.0, 5.0, 6.0, 7.0, 8.0)


def test_mirrored_changes_what_counts_in_the_sense_of_rotation():
    assert mirrored(ROD) == ArticulatedRod(SliderCrank(1.0, 2.0, -3.0), 4.0, -5.0, -6.0, 7.0, -8.0)
    assert mirrored(CrankRocker(1.0, 2.0, 3.0, 4.0, 1.0)) == CrankRocker(1.0, 2.0, 3.0, 4.0, -1.0)
    assert mirrored(mirrored(ROD)) == ROD


def test_geometries_are_put_together_with_designs_first():
    found = by_design([ROD, as_columns(mirrored(ROD), ROD, ROD)], 3)
    assert found.master.offset.shape == (3, 2, 1)
    assert found.master.offset[..., 0].tolist() == [[3, -3], [3, 3], [3, 3]]
    assert found.bank_angle[0, :, 0].tolist() == [6, -6]


def test_named_parts():
    assert named_part(ROD, "master.rod_length") == 2.0
    assert named_part(ROD, "rod_length") == 7.0
    assert scaled(ROD, "master.rod_length", 10.0) == ROD._replace(master=SliderCrank(1.0, 20.0, 3.0))
    assert scaled(ROD, "knuckle_radius", 0.5).knuckle_radius == 2.0


def test_leaves_and_rows():
    found = by_design([ROD, as_columns(mirrored(ROD), ROD)], 2)
    assert [leaf[0, 0, 0] for leaf in leaves(found)] == [1, 2, 3, 4, 5, 6, 7, 8]
    some = rows(found, np.array([1, 2]))
    assert some.master.offset.tolist() == [[-3.0], [3.0]]
    assert rows(found, np.array([[3]])).offset.shape == (1, 1, 1)


@pytest.mark.parametrize("name", ["rod", "master.rod"])
def test_unknown_parts_are_errors(name):
    with pytest.raises(AttributeError):
        named_part(ROD, name)
