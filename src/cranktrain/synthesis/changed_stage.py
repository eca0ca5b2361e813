"""The stage of a drive whose ratio is sought: the largest one."""

from collections.abc import Iterator

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.numerics.ties import first_largest


def without_stage(spec: DriveSpec | None) -> Iterator[Problem]:
    """Refuse a machine without a stage: there is no ratio to be sought."""
    if spec is None or not spec.stage:
        allowed = _("is missing: a ratio is that of a stage; [[drive.stage]] ratio = 1 would do")
        yield Problem("drive.stage", None, allowed)


def largest_stage(spec: DriveSpec) -> int:
    """Place of the stage with the largest ratio, the first of equal ones; there is one."""
    return first_largest([stage.ratio.si for stage in spec.stage])
