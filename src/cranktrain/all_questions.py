"""Every question that can be asked of a machine, in the order in which people ask them, and tables that few have."""

from collections.abc import Container, Mapping
from typing import TYPE_CHECKING

from cranktrain.folders import Folders
from cranktrain.layout.question import Question
from cranktrain.when_given import when_given

if TYPE_CHECKING:
    from cranktrain.layout.drive.table import DriveSpec
    from cranktrain.questions.crankshaft.spec import CrankshaftSpec, GearSpec
    from cranktrain.questions.pumping.spec import PumpingSpec
    from cranktrain.questions.rod_load.spec import RodSpec
    from cranktrain.questions.torsion.spec import TorsionSpec
else:
    CrankshaftSpec = when_given("cranktrain.questions.crankshaft.spec", "CrankshaftSpec")
    DriveSpec = when_given("cranktrain.layout.drive.table", "DriveSpec")
    GearSpec = when_given("cranktrain.questions.crankshaft.spec", "GearSpec")
    PumpingSpec = when_given("cranktrain.questions.pumping.spec", "PumpingSpec")
    RodSpec = when_given("cranktrain.questions.rod_load.spec", "RodSpec")
    TorsionSpec = when_given("cranktrain.questions.torsion.spec", "TorsionSpec")

__all__ = [
    "QUESTIONS",
    "CrankshaftSpec",
    "DriveSpec",
    "GearSpec",
    "PumpingSpec",
    "Questions",
    "RodSpec",
    "TorsionSpec",
]


class Questions(Folders[Question]):
    """Questions by the names of their folders, each with the tables of the machine file that ask it.

    Parameters
    ----------
    asked_by : mapping of str to tuple of str
        Any of these tables asks the question; one without any is asked of every machine.
    """

    def __init__(self, asked_by: Mapping[str, tuple[str, ...]]) -> None:
        super().__init__("cranktrain.questions", "QUESTION", tuple(asked_by))
        self.asked_by = asked_by

    def by(self, tables: Container[str]) -> tuple[str, ...]:
        """Name those that a file with some tables asks."""
        return tuple(name for name, keys in self.asked_by.items() if not keys or any(key in tables for key in keys))


QUESTIONS = Questions(
    {
        "motion": (),
        "cylinders": (),
        "gas": (),
        "forces": (),
        "loads": (),
        "torque": (),
        "pumping": ("pumping",),
        "balance": (),
        "evenness": (),
        "wear": (),
        "rod_load": ("gas", "rod_load"),
        "crankshaft": ("crankshaft", "gear"),
        "torsion": ("torsion",),
        "reduction": ("drive",),
        "drive": ("drive",),
        "servo": ("drive",),
        "sizing": ("drive",),
        "start": ("drive",),
        "press": ("drive",),
    }
)
