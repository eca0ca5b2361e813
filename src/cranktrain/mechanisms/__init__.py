"""Mechanisms: one folder for each kind, with its spec, kernels, drawing and README; a new kind is one line here."""

from typing import TYPE_CHECKING

from cranktrain.folders import Folders
from cranktrain.mechanisms.kind import AnyKind, Kind
from cranktrain.mechanisms.spec import MechanismSpec
from cranktrain.when_given import by_kind

__all__ = ["KINDS", "AnyMechanism", "Kind", "MechanismSpec", "kind_of"]

KINDS: Folders[AnyKind] = Folders(
    "cranktrain.mechanisms",
    "KIND",
    (
        "slider_crank",
        "crank_rocker",
        "articulated_rod",
        "scotch_yoke",
        "oscillating_cylinder",
        "slotted_lever",
        "eccentric",
        "stephenson",
        "walschaerts",
        "chain",
    ),
)

if TYPE_CHECKING:
    AnyMechanism = MechanismSpec
else:
    AnyMechanism = by_kind(KINDS)


def kind_of(spec: MechanismSpec) -> AnyKind:
    """Give the kind of a mechanism; where the file composes it, a kind of its own."""
    kind = KINDS.named(spec.kind)
    if kind.structure_of is None or kind.of_structure is None:
        return kind
    return kind.of_structure(kind.structure_of(spec))
