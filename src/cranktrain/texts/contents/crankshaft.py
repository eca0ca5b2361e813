"""The text on reactions of a crankshaft's supports, (44) to (53), fig. 35."""

from cranktrain.language import N_
from cranktrain.texts.contents.text import Formula, Text

_SPLIT = N_("one throw between two supports, hinged at both")
_THROW = "cranktrain textbook --throw example"
_OF_MACHINE = "cranktrain textbook --throw kamaz_740 --throw-number 3 --at 420"
_FIRST, _LAST = (f"cranktrain textbook --throw kamaz_740 --throw-number {number}" for number in (1, 4))
_WEIGHED = """--set 'balance.weight=[{{mass = "1.2 kg", radius = "70 mm", angle = "{angle} deg", z = "{z} mm"}}]'"""
"""An external counterweight, which the example has none of."""
_SENSE = N_("x, left open, is against the rotation: only so may it be added to (51), (53); only sums of C8 + C14 occur")

TEXT = Text(
    name="crankshaft-reactions",
    title=N_("reactions of a crankshaft's supports, throw by throw"),
    said_of=N_(
        "crankshafts with their supports, a throw at a time: `cranktrain textbook --throw example`, or of an engine "
        "with [crankshaft], such as `cranktrain textbook --throw kamaz_740`"
    ),
    letter="E",
    formulas=(
        Formula(
            "(44)",
            N_("right support, in the crank's plane, of centrifugal forces"),
            "right",
            _THROW,
            _SPLIT,
            N_("C3 and C5 hold what turns of the rods, so K must not; l is no input but the sum of the chain"),
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(45)",
            N_("right support, across the crank's plane, of centrifugal forces"),
            "right",
            _THROW,
            _SPLIT,
            _SENSE,
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(46)",
            N_("left support, in the crank's plane, of centrifugal forces"),
            "right",
            _THROW,
            _SPLIT,
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(47)",
            N_("left support, across the crank's plane, of centrifugal forces"),
            "right",
            _THROW,
            _SPLIT,
            _SENSE,
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(48)",
            N_("the first throw's four, with external counterweights"),
            "right",
            _THROW,
            _SPLIT,
            N_("C10 is with the rotation"),
            of_machine=f"{_FIRST} {_WEIGHED.format(angle=-190, z=-110)}",
        ),
        Formula(
            "(49)",
            N_("the last throw's four, with external counterweights"),
            "right",
            _THROW,
            _SPLIT,
            N_(
                "C12 is against the rotation; (48) and (49), or end moments of the continuous beam: both count the "
                "counterweights twice"
            ),
            of_machine=f"{_LAST} {_WEIGHED.format(angle=30, z=620)}",
        ),
        Formula(
            "fig. 35",
            N_("loads and lengths of a throw"),
            "right",
            "cranktrain textbook --throw example -o throw.svg",
            note=N_("l7, which it has, occurs in no formula"),
            of_machine=f"{_OF_MACHINE} -o third.svg",
        ),
        Formula(
            "(50)",
            N_("right support, in the crank's plane, of the rods' normal forces"),
            "right",
            _THROW,
            _SPLIT,
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(51)", N_("right support, of the rods' tangential forces"), "right", _THROW, _SPLIT, of_machine=_OF_MACHINE
        ),
        Formula(
            "(52)",
            N_("left support, in the crank's plane, of the rods' normal forces"),
            "right",
            _THROW,
            _SPLIT,
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(53)", N_("left support, of the rods' tangential forces"), "right", _THROW, _SPLIT, of_machine=_OF_MACHINE
        ),
        Formula(
            "after (53)",
            N_("“a fully balanced throw has no reactions of rotating masses”"),
            "right in a range",
            f"{_THROW} --full",
            N_("static and dynamic balance: ΣC = 0 and ΣCz = 0 in both planes"),
            N_("C4 balanced by C1 alone leaves R_KCP = −C4(2l2 + 2l3 + hL)/2l"),
            of_machine=f"{_OF_MACHINE} --full",
        ),
        Formula(
            "each throw",
            N_("the same of every throw of an engine, with its own lengths and forces"),
            "right",
            "cranktrain textbook --throw vaz_21213 --throw-number 3",
            note=N_("together they are the loads of the shaft that is split at its bearings"),
        ),
        Formula(
            "first throw",
            N_("with (48), if there is an external counterweight on its side"),
            "right",
            "cranktrain textbook --throw vaz_21213 --throw-number 1",
        ),
        Formula(
            "last throw",
            N_("with (49)"),
            "right",
            "cranktrain textbook --throw vaz_21213 --throw-number 4",
        ),
        Formula(
            "continuous",
            N_("equations of three and of five moments, and a frame of throws, beside the split shaft"),
            "right",
            "cranktrain plot vaz_21213 --sheet crankshaft -o crankshaft.svg",
            note=N_("the text names the equations and gives none"),
        ),
        Formula(
            "polar",
            N_("loads of the bearings as polar diagrams"),
            "right",
            "cranktrain plot vaz_21213 --plan polar -o polar.svg",
            note=N_("not in the text"),
        ),
        Formula(
            "wear",
            N_("where the loads wear pins and journals"),
            "right",
            "cranktrain plot vaz_21213 --sheet wear -o wear.svg",
            note=N_("not in the text"),
        ),
    ),
)
