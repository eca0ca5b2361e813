"""What a record must do as a frozen dataclass does; what it must not is be equal to another one."""

import copy
import pickle
from collections.abc import Mapping
from dataclasses import FrozenInstanceError, dataclass, field, fields, is_dataclass, replace
from functools import cached_property
from inspect import signature

import numpy as np
import pytest

from cranktrain.record import record


@record
class Rod:
    """A rod."""

    length: float
    joints: tuple[str, ...] = ()
    labels: Mapping[str, int] = field(default_factory=dict)

    @cached_property
    def half(self):
        return self.length / 2


@record
class Forked(Rod):
    """A rod with a fork."""

    fork: float = field(kw_only=True)


@record
class Named:
    """Fields by the names that its `__init__` might use."""

    own: float
    cls: float
    fields: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Model:
    """The same by the library."""

    length: float
    joints: tuple[str, ...] = ()


ROD = Rod(0.136, ("crank_pin",))


def test_fields_are_those_of_a_dataclass():
    assert is_dataclass(ROD)
    assert [each.name for each in fields(Forked)] == ["length", "joints", "labels", "fork"]
    assert (ROD.length, ROD.joints, ROD.labels) == (0.136, ("crank_pin",), {})
    assert replace(ROD, length=0.2).joints == ("crank_pin",)
    assert Forked(0.1, fork=0.02).fork == 0.02


@pytest.mark.parametrize("one", [ROD, Forked(0.1, fork=0.02), Model(0.136)], ids=lambda one: type(one).__name__)
def test_nothing_can_be_changed(one):
    before = dict(vars(one))
    for name in ("length", "joints", "new"):
        with pytest.raises(FrozenInstanceError, match=name):
            setattr(one, name, 1.0)
        with pytest.raises(FrozenInstanceError, match=name):
            delattr(one, name)
    assert vars(one) == before


def test_it_is_shown_as_a_dataclass_is():
    assert repr(Rod(0.136, ("pin",))) == "Rod(length=0.136, joints=('pin',), labels={})"
    assert repr(Model(0.136, ("pin",))) == "Model(length=0.136, joints=('pin',))"


def test_what_it_takes_is_what_a_dataclass_takes():
    """Before there is an instance as after it, with the fields' types, and whatever their names are."""

    @dataclass(eq=False)
    class Other(Rod):
        fork: float = field(kw_only=True)

    for _time in range(2):
        assert str(signature(Forked)) == str(signature(Other))
        with pytest.raises(TypeError, match=r"missing 1 required keyword-only argument: 'fork'"):
            Forked(0.1)
    assert Forked.__init__.__qualname__ == "Forked.__init__"
    assert (Named(1.0, cls=2.0).own, Named(1.0, 2.0, ("a",)).fields) == (1.0, ("a",))
    assert Rod(0.1).labels is not Rod(0.2).labels


def test_it_is_equal_to_itself_alone():
    one, other = Rod(np.ones(3)), Rod(np.ones(3))
    assert one == one
    assert one != other
    assert len({one, other}) == 2


def test_what_is_found_once_is_kept():
    assert ROD.half == 0.068
    assert vars(ROD)["half"] == 0.068


def test_copies_hold_the_same():
    assert vars(copy.copy(ROD)) == vars(ROD)
    assert vars(pickle.loads(pickle.dumps(ROD))) == vars(ROD)
