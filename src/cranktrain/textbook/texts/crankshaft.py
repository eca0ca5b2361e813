"""The text on reactions of a crankshaft's supports, (44) to (53), fig. 35."""

from cranktrain.language import N_
from cranktrain.textbook.texts.text import Formula, Text

_SPLIT = N_("one throw between two supports, hinged at both")

TEXT = Text(
    name="crankshaft-reactions",
    title=N_("reactions of a crankshaft's supports, throw by throw"),
    said_of=N_("crankshafts with their supports, which no machine file has yet"),
    formulas=(
        Formula("(44)", N_("right support, in the crank's plane, of centrifugal forces"), "right", valid=_SPLIT),
        Formula("(45)", N_("right support, across the crank's plane, of centrifugal forces"), "right", valid=_SPLIT),
        Formula("(46)", N_("left support, in the crank's plane, of centrifugal forces"), "right", valid=_SPLIT),
        Formula("(47)", N_("left support, across the crank's plane, of centrifugal forces"), "right", valid=_SPLIT),
        Formula("(48)", N_("the first throw's four, with external counterweights"), "right", valid=_SPLIT),
        Formula(
            "(49)",
            N_("the last throw's four, with external counterweights"),
            "right",
            valid=_SPLIT,
            note=N_("these, or end moments of the continuous beam: both count the counterweights twice"),
        ),
        Formula("fig. 35", N_("loads and lengths of a throw"), "right"),
        Formula("(50)", N_("right support, in the crank's plane, of the rods' normal forces"), "right", valid=_SPLIT),
        Formula("(51)", N_("right support, of the rods' tangential forces"), "right", valid=_SPLIT),
        Formula("(52)", N_("left support, in the crank's plane, of the rods' normal forces"), "right", valid=_SPLIT),
        Formula("(53)", N_("left support, of the rods' tangential forces"), "right", valid=_SPLIT),
    ),
)
