"""The result: units, read-only arrays, facts, what is missing, the dataset."""

import inspect
import sys

import numpy as np
import pytest
import xarray
from tests.machines import V12, slider, throws
from tests.told import line_of, texts_of

import cranktrain as ct
from cranktrain.analysis import every_stage
from cranktrain.errors import InputError
from cranktrain.questions.evenness.flywheel import FlywheelSize
from cranktrain.questions.motion.pistons import PistonSpeeds
from cranktrain.questions.motion.rockers import RockerMotion
from cranktrain.saying.catalogue import entries


@pytest.fixture(scope="module")
def v12():
    return ct.run(ct.Machine(name="V12", **V12))


def test_crank_angles_are_in_degrees_and_other_angles_in_radians(v12):
    assert v12.catalogue["top_dead_centre"].unit == "deg"
    assert v12.catalogue["rod_angle"].unit == "rad"
    assert v12.top_dead_centre[1] == pytest.approx(120)
    assert np.max(np.abs(v12.rod_angle)) < 1


def test_arrays_cannot_be_written(v12):
    for name in ("crank_angle", *v12.catalogue):
        if np.ndim(getattr(v12, name)) == 0:
            continue
        with pytest.raises(ValueError, match="read-only"):
            getattr(v12, name)[...] = 0.0
    with pytest.raises(ValueError, match="read-only"):
        v12.checks[0].residual[...] = 0.0


def test_facts_are_the_quantities_without_crank_angle(v12):
    assert set(v12.facts) == {name for name, entry in v12.catalogue.items() if "crank_angle" not in entry.dimensions}
    assert v12.facts["stroke"].entry.symbol == "S"
    assert v12.facts["stroke"].value is not None
    assert "piston_displacement" not in v12.facts


def test_unknown_names(v12):
    with pytest.raises(AttributeError, match=r"no strok; did you mean stroke\?"):
        _ = v12.strok
    with pytest.raises(AttributeError, match=r"no sumary; did you mean summary\?"):
        _ = v12.sumary
    with pytest.raises(AttributeError, match="no swing, which other machines have"):
        _ = v12.swing
    with pytest.raises(AttributeError, match="no quux; its `catalogue` names all"):
        _ = v12.quux
    assert "stroke" in dir(v12)


def test_absent_quantities_name_what_they_need():
    result = ct.run(ct.Machine(mechanism=slider()))
    with pytest.raises(
        AttributeError, match=r"no compression_ratio, which needs \[cylinder\] bore, \[cylinder\] compr"
    ):
        _ = result.compression_ratio


def test_what_a_stage_gave_is_had_by_its_type(v12):
    speeds = v12[PistonSpeeds]
    np.testing.assert_array_equal(speeds.mean_piston_speed[0], v12.mean_piston_speed)
    assert v12.get(PistonSpeeds) is speeds
    assert v12.get(FlywheelSize) is None


def test_what_a_stage_did_not_give_names_what_it_needs(v12):
    with pytest.raises(KeyError, match=r"no FlywheelSize, which needs .*\[evenness\] coefficient"):
        _ = v12[FlywheelSize]
    with pytest.raises(KeyError, match=r"no RockerMotion; it has .*DeadCentres.* PistonSpeeds"):
        _ = v12[RockerMotion]
    assert "[evenness] coefficient" in texts_of(v12.needs_of("flywheel_inertia"))
    assert v12.needs_of("stroke") == ()


def test_labels(v12):
    entry = v12.catalogue["displacement_error"]
    assert list(v12.labels_of(entry)) == ["motion_method", "piston"]
    assert v12.labels_of(entry)["motion_method"][0] == "exact"


def test_dataset(v12):
    data = v12.dataset
    assert data.attrs["name"] == "V12"
    assert set(data.data_vars) == set(v12.catalogue)
    one = data["piston_displacement"].sel(piston="3R", crank_angle=90.0)
    assert float(one) == v12.piston_displacement[8, 90]
    assert one.attrs == {
        "units": "m",
        "symbol": "x",
        "long_name": "Travel of the piston from its true top toward the shaft",
        "source": "docs/theory/slider-crank",
        "equation": "2.3 to 2.5",
    }
    assert data["stroke"].attrs["line"] == "S = H − h"
    assert data["crank_angle"].attrs["units"] == "deg"
    assert "design" not in data.dims


def test_dataset_without_its_package(monkeypatch):
    monkeypatch.setitem(sys.modules, "xarray", None)
    with pytest.raises(InputError) as found:
        _ = ct.run("3d12", quantities="stroke").dataset
    assert str(found.value) == (
        "dataset: needs the package xarray; pip install 'cranktrain[dataset]', or take arrays by their names"
    )


def test_every_dimension_can_be_selected_by_its_name(v12):
    """What xarray itself takes by name when it selects (method, tolerance, drop, …) would select nothing."""
    names = {name for stage in every_stage() for entry in entries(stage.gives) for name in entry.dimensions}
    for container in (xarray.Dataset, xarray.DataArray):
        for select in ("sel", "isel", "interp", "reindex", "drop_sel", "drop_isel"):
            assert not set(inspect.signature(getattr(container, select)).parameters) & names
    errors = v12.dataset["displacement_error"]
    assert list(errors["motion_method"].values)[:2] == ["exact", "infinite_rod"]
    assert float(errors.sel(motion_method="infinite_rod", piston="1L")) == v12.displacement_error[1, 0] != 0


def test_numbers_are_numbers_in_the_dataset(v12):
    data = v12.dataset
    assert float(data["phase_star_sum"].sel(order=6)) == v12.phase_star_sum[11]  # in halves: 0.5, 1, …, 6
    assert data["piston"].dtype.kind == "U"
    journals = ct.run("vaz_21213", quantities="largest_journal_torque").dataset["journal"]
    assert journals.dtype.kind == "i"
    assert journals.values.tolist() == [1, 2, 3, 4, 5]


def test_dataset_has_what_was_asked_for():
    result = ct.run(ct.Machine(mechanism=slider()), quantities=("stroke", "piston_displacement"))
    assert list(result.dataset) == ["stroke", "piston_displacement"]
    assert list(ct.run(ct.Machine(mechanism=slider()), quantities="stroke").dataset) == ["stroke"]


def test_dataset_of_designs():
    machines = [ct.Machine(mechanism=slider(crank_radius=f"{radius} mm"), shaft=throws(0)) for radius in (40, 50)]
    data = ct.run(machines).dataset
    np.testing.assert_allclose(data["stroke"].sel(design=2), [0.1])
    assert data["piston_displacement"].dims == ("design", "piston", "crank_angle")


def test_summary_answers_in_the_order_in_which_one_asks(v12):
    assert [line.partition(":")[0] for line in v12.summary().splitlines()] == [
        "Motion",
        "  stroke",
        "  true top dead centre",
        "  true bottom dead centre",
        "  mean piston speed",
        "  largest piston speed",
        "  largest acceleration",
        "  largest pressure angle",
        "Cylinders",
        "  swept volume",
        "  compression ratio",
        "  firing order",
        "Torque",
        "  major orders",
    ]
    assert line_of(v12, "Cylinders", "firing order") == "1L-6R-5L-2R-3L-4R-6L-1R-2L-5R-4L-3R, every 60°"


def test_flags(v12):
    assert any("(334)" in flag and "λ < 0.1" in flag and "1L–6L" in flag for flag in texts_of(v12.flags))
