"""What Python's users may write for a sweep, for values of a machine: each mistake is a sentence."""

import numpy as np
import pandas as pd
import pytest
from tests.machines import slider
from tests.sentences import FOLDER_NOT_THERE, NO_PATH, NOT_A_KEY, WHOLE_NUMBER

import cranktrain as ct

MACHINE = ct.Machine(
    mechanism=slider(), shaft={"main": {"speed": "1500 rpm"}}, cylinder={"bore": "80 mm", "compression_ratio": 9}
)
RODS = {"rod_length": "140, 150 mm"}
BY_PATH = 'must be values by path, or a sequence of such; write like {"rod_length": "130..160 mm:31"}'
ONE_BY_ONE = "must be values, one by one, or a text such as 130..160 mm:31"
WHOLE = f"{WHOLE_NUMBER}, at least 1"
MAPPING = 'must be a mapping of paths to values; write machine.with_({"mechanism.rod_length": "140 mm"})'


@pytest.mark.parametrize(
    ("vary", "said"),
    [
        (None, f"vary = None: {BY_PATH}"),
        (5, f"vary = 5: {BY_PATH}"),
        ("rod_length=1", f"vary = rod_length=1: {BY_PATH}"),
        (pd.DataFrame({"a": [9]}), f"vary = a 0 9: {BY_PATH}"),
        ({}, "vary: is missing: name what is to be varied"),
        ([], "cases: has no design"),
        ([{}], "cases: has no design"),
        (["rod_length"], 'vary[0] = rod_length: must be values by path; write like {"rod_length": "130 mm"}'),
        ([{"rod_length": "1 m"}, None], 'vary[1] = None: must be values by path; write like {"rod_length": "130 mm"}'),
        ({5: "1 mm"}, f"5: {NO_PATH}: names with dots between"),
        ([{None: "1 mm"}], f"None: {NO_PATH}: names with dots between"),
        ({"rod_lenght": "140, 150 mm"}, "rod_lenght: is no key of this machine's file; did you mean rod_length?"),
        ({"rod_length": "140, 150 kg"}, "kg measures a mass"),
        ({"rod_length": None}, f"mechanism.rod_length = None: {ONE_BY_ONE}"),
        ({"rod_length": 0.14}, f"mechanism.rod_length = 0.14: {ONE_BY_ONE}"),
        ({"rod_length": b"ab"}, f"mechanism.rod_length = b'ab': {ONE_BY_ONE}"),
        ({"compression_ratio": np.array(8.0)}, f"cylinder.compression_ratio = 8.0: {ONE_BY_ONE}"),
        ({"rod_length": ["140 mm", None]}, "mechanism.rod_length = None: is no value"),
        ({"rod_length": []}, "mechanism.rod_length: must have at least one value"),
        ({"rod_length": "140,5 mm"}, "has a comma between digits"),
        ({"compression_ratio": [np.nan]}, "cylinder.compression_ratio = nan: must be finite"),
        ({"compression_ratio": [10**400]}, "cylinder.compression_ratio"),
        ({"rod_length": "1 m", "mechanism.rod_length": "2 m"}, "mechanism.rod_length: is varied twice"),
        ([{"rod_length": "1 m", "mechanism.rod_length": "2 m"}], "mechanism.rod_length: is varied twice"),
        ([{"compression_ratio": [9, 10]}], "cylinder.compression_ratio: must be a number without a unit"),
    ],
    ids=str,
)
def test_what_is_no_values(vary, said):
    with pytest.raises(ct.InputError) as caught:
        ct.sweep(MACHINE, vary, "stroke")
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"wanted": "strok"}, "wanted = strok: is no result of this machine; did you mean stroke?"),
        ({"wanted": 5}, "wanted = 5: must be names of results"),
        ({"wanted": [None]}, "wanted = None: must be names of results"),
        ({"wanted": []}, "wanted = []: must be names of results"),
        ({"wanted": "stroke, displacement"}, "write them one by one: ['stroke', 'displacement']"),
        ({"processes": 0}, f"processes = 0: {WHOLE}"),
        ({"processes": "2"}, f"processes = '2': {WHOLE}"),
        ({"processes": 2.5}, f"processes = 2.5: {WHOLE}"),
        ({"processes": True}, f"processes = True: {WHOLE}"),
        ({"store": 5}, 'store = 5: must be the path of a folder, "NAME.zarr"'),
        ({"store": "rods.csv"}, 'store = rods.csv: must be the path of a folder, "NAME.zarr"'),
        ({"resume": True}, 'resume: needs a store; write store="NAME.zarr"'),
        ({"scheduler": 5}, "scheduler = 5: must be the address of a scheduler, or a client of Dask's that knows one"),
    ],
    ids=str,
)
def test_parameters_that_say_nothing(options, said):
    with pytest.raises(ct.InputError) as caught:
        ct.sweep(MACHINE, RODS, **{"wanted": "stroke", **options})
    assert said in str(caught.value)


def test_a_store_in_a_folder_that_is_not_there(tmp_path):
    with pytest.raises(ct.InputError, match=FOLDER_NOT_THERE):
        ct.sweep(MACHINE, RODS, "stroke", store=tmp_path / "no" / "rods.zarr")
    assert list(tmp_path.iterdir()) == []


def test_a_sweep_is_of_one_machine():
    with pytest.raises(ct.InputError, match=r"^machine: must be one; of several, run\(\[…\]\) gives all results"):
        ct.sweep([MACHINE, "3d12"], RODS, "stroke")


def test_a_design_that_is_not_there():
    found = ct.sweep(MACHINE, RODS, "stroke")
    for place in (-1, 2):
        with pytest.raises(ct.InputError, match=f"place = {place}: must be from 0 to 1"):
            found.values_at(place)


@pytest.mark.parametrize(
    ("values", "said"),
    [
        (None, f"with_ = None: {MAPPING}"),
        ("rod_length=1", f"with_ = rod_length=1: {MAPPING}"),
        ({5: "1 mm"}, f"5: {NO_PATH}"),
        ({"rod_length": "140 mm"}, f"rod_length = 140 mm: {NOT_A_KEY}; write [mechanism] rod_length"),
        ({"mechanism.rod_lenght": "1 mm"}, "did you mean rod_length?"),
        ({"mechanism.rod_length": 0.14}, 'write "0.14 m" or "0.14 mm"'),
        ({"mechanism.rod_length": "140,5 mm"}, 'write "140.5 mm"'),
        ({"mechanism.rod_length": None}, "mechanism.rod_length: is missing"),
        ({"mechanism.rod_length": "1e400 mm"}, "must be within what a computer number holds"),
        ({"cylinder.compression_ratio": np.array([9.0, 10.0])}, "must be a number without a unit"),
        ({"cylinder.compression_ratio": np.nan}, "must be finite"),
    ],
    ids=str,
)
def test_values_that_a_machine_cannot_have(values, said):
    with pytest.raises(ct.InputError) as caught:
        MACHINE.with_(values)
    assert said in str(caught.value)


@pytest.mark.parametrize("ratio", [np.int64(10), np.float32(10), np.array(10)])
def test_numbers_of_numpy_are_numbers(ratio):
    assert MACHINE.with_({"cylinder.compression_ratio": ratio}).cylinder.compression_ratio.si == 10


def test_arrays_of_numpy_are_lists():
    line = {"bank": {"line": {"mechanism": slider()}}, "shaft": {"main": {"throws": ["0 deg", "180 deg"]}}}
    machine = ct.Machine(**line).with_({"shaft.main.throws": np.array(["0 deg", "90 deg"])})
    assert machine.shaft["main"].throws[1].si == np.pi / 2
