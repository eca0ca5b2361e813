"""The compiled cycle and its kernels are such that a graphics processor could run them: they compile to PTX.

Where numba-cuda and its NVVM are (`pip install 'numba-cuda[cu12]'`); no graphics processor is needed.
"""

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.weighed_machines import CLOSED_FORMS, WEIGHED

import cranktrain as ct
from cranktrain.columns import in_columns
from cranktrain.study.cycle import road
from cranktrain.study.cycle.road import CompiledWay, facts_of_cycles, way_to
from cranktrain.study.cycle.source import WrittenLoops

pytest.importorskip("numba_cuda", reason="numba-cuda is not installed: pip install 'numba-cuda[cu12]'")
from numba import cuda, typeof, types  # below: it is numba-cuda that replaces this
from numba.cuda import libdevice, ufuncs

SINGLE = str(Path(__file__).parents[2] / "benchmarks" / "single.toml")
HOPPER = (9, 0)
"""Compute capability of a processor that need not be there."""


class Reached(Exception):
    """The loop is written, and about to be called."""


def sign_of(number):
    return 1.0 if number > 0.0 else (-1.0 if number < 0.0 else number)


def of_library(function):
    """How a function of the library is put in place of NumPy's."""

    def put(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        return context.get_function(function, signature)(builder, given)

    return put


def put_sign(context: Any, builder: Any, signature: Any, given: Any) -> Any:
    return context.compile_internal(builder, sign_of, signature, given)


LACKING = {
    np.sqrt: {"d->d": of_library(libdevice.sqrt)},
    np.exp: {"d->d": of_library(libdevice.exp)},
    np.absolute: {"d->d": of_library(libdevice.fabs)},
    np.floor: {"d->d": of_library(libdevice.floor)},
    np.rint: {"d->d": of_library(libdevice.rint)},
    np.sign: {"d->d": put_sign},
    np.copysign: {"dd->d": of_library(libdevice.copysign)},
}
"""Functions of NumPy that loops and kernels call and that numba-cuda has no table of."""


@pytest.fixture(autouse=True)
def no_processor(monkeypatch):
    """Functions that others call are compiled for the processor that is there: for one that is not."""
    monkeypatch.setattr("numba.cuda.dispatcher.get_current_device", lambda: SimpleNamespace(compute_capability=HOPPER))
    for function, loops in LACKING.items():
        monkeypatch.setitem(ufuncs.ufunc_db(), function, loops)
    try:
        ptx_of(sign_of, (types.float64,))
    except Exception as problem:  # numba-cuda raises whatever the parts of it that are missing raise
        pytest.skip(f"numba-cuda finds no NVVM: {problem}")


def ptx_of(function, signature):
    return cuda.compile(function, signature, cc=HOPPER, device=True, abi="numba", output="ptx")[0]


def written_for(machine, facts, monkeypatch):
    """The loop over designs, and the types that it is given."""
    way, whole = way_to(machine, facts), road.loaded_loops
    assert isinstance(way, CompiledWay)
    found: list[Any] = []

    def loaded(written: WrittenLoops) -> Any:
        module: Any = whole(written)
        if not hasattr(module, "cycle"):
            return module

        def reached(*given: Any) -> None:
            found.extend([module.cycle.py_func, tuple(map(typeof, given))])
            raise Reached

        return SimpleNamespace(cycle=reached)

    monkeypatch.setattr(road, "loaded_loops", loaded)
    with pytest.raises(Reached):
        facts_of_cycles(in_columns([machine] * 2), 2, way)
    return found


@pytest.mark.parametrize("name", CLOSED_FORMS)
def test_kernels_of_closed_forms(name, monkeypatch):
    """Motion, load, forces and what is reduced to the shaft, in the loop that calls them."""
    machine = WEIGHED[name].with_({"evenness.flywheel": "1 kg*m^2"})
    loop, signature = written_for(machine, ["largest_torque", "coefficient_of_fluctuation"], monkeypatch)
    assert ".target sm_90" in ptx_of(loop, signature)


@pytest.mark.parametrize("name", [SINGLE, "vaz_21213", "gas_compressor"])
def test_whole_cycles(name, monkeypatch):
    """All that is asked of a cylinder: gas, forces along rods and in joints."""
    facts = ["largest_torque", "largest_crankpin_load", "largest_side_force", "peak_pressure"]
    loop, signature = written_for(ct.load(name), facts, monkeypatch)
    assert ".target sm_90" in ptx_of(loop, signature)
