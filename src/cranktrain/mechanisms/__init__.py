"""Mechanisms: one folder for each kind, with its spec, kernels, drawing and README; a new kind is one line here."""

from typing import TYPE_CHECKING

from cranktrain.mechanisms import (
    articulated_rod,
    chain,
    crank_rocker,
    eccentric,
    oscillating_cylinder,
    scotch_yoke,
    slider_crank,
    slotted_lever,
    stephenson,
    walschaerts,
)
from cranktrain.mechanisms.kind import AnyKind, Kind
from cranktrain.mechanisms.spec import MechanismSpec
from cranktrain.spec_class import by_kind

__all__ = ["KINDS", "AnyMechanism", "Kind", "MechanismSpec", "kind_named", "kind_of"]

KINDS: tuple[AnyKind, ...] = (
    slider_crank.KIND,
    crank_rocker.KIND,
    articulated_rod.KIND,
    scotch_yoke.KIND,
    oscillating_cylinder.KIND,
    slotted_lever.KIND,
    eccentric.KIND,
    stephenson.KIND,
    walschaerts.KIND,
    chain.KIND,
)

if TYPE_CHECKING:
    AnyMechanism = MechanismSpec
else:
    AnyMechanism = by_kind(kind.spec for kind in KINDS)


def kind_named(name: str) -> AnyKind:
    """Give the kind of that name."""
    return next(kind for kind in KINDS if kind.name == name)


def kind_of(spec: MechanismSpec) -> AnyKind:
    """Give the kind of a mechanism; where the file composes it, a kind of its own."""
    kind = kind_named(spec.kind)
    return kind if kind.composed is None else kind.composed(spec)
