"""Mechanisms: one folder for each kind, with its spec, kernels, drawing and README; a new kind is one line here."""

from typing import Annotated

from pydantic import Field

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

AnyMechanism = Annotated[
    slider_crank.SliderCrankSpec
    | crank_rocker.CrankRockerSpec
    | articulated_rod.ArticulatedRodSpec
    | scotch_yoke.ScotchYokeSpec
    | oscillating_cylinder.OscillatingCylinderSpec
    | slotted_lever.SlottedLeverSpec
    | eccentric.EccentricSpec
    | stephenson.StephensonSpec
    | walschaerts.WalschaertsSpec
    | chain.ChainSpec,
    Field(discriminator="kind"),
]


def kind_named(name: str) -> AnyKind:
    """Give the kind of that name."""
    return next(kind for kind in KINDS if kind.name == name)


def kind_of(spec: MechanismSpec) -> AnyKind:
    """Give the kind of a mechanism; where the file composes it, a kind of its own."""
    kind = kind_named(spec.kind)
    return kind if kind.composed is None else kind.composed(spec)
