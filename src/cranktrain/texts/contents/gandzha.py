"""Gandzha's text on the torque and flywheel moment of a crank-rocker's drive, (1) to (21), figs. 1 and 2."""

from cranktrain.language import N_
from cranktrain.texts.contents.text import Formula, Text

_CENTRES = "cranktrain plot pumping_unit_c57 --plan centres --at 60,150 -o unit.svg"
_RATIO = "cranktrain textbook pumping_unit_c57 --source gandzha --table"
_DRIVE = "cranktrain textbook --drive example --full"
_OF_MACHINE = "cranktrain textbook --drive tilting_table --full"
_DRAWN = "cranktrain textbook --drive example -o drive.svg"
_DRAWN_OF_MACHINE = "cranktrain textbook --drive tilting_table -o table.svg"
_LOSSES = N_("η stands in the denominator always; where the mechanism drives the motor losses help it")

TEXT = Text(
    name="gandzha",
    title=N_("static torque and flywheel moment of a crank-rocker's drive"),
    said_of=N_("crank-rockers"),
    letter="B",
    of_machine="gandzha",
    authors=("Ганджа",),
    formulas=(
        Formula(
            "fig. 1",
            N_("scheme: motor, gearbox, crank OB, rod AB, rocker O₁A that swings through γ"),
            "right",
            "cranktrain plot pumping_unit_c57 --plan scheme -o scheme.svg",
            note=N_("motor and gears are drawn beside it where [drive] has them"),
            of_machine="cranktrain plot tilting_table --plan scheme -o tilting.svg",
        ),
        Formula(
            "(1)",
            N_("useful torque on the rocker by the rod's force, Q r₁ = Q′ r₁ sin(α₁ − β)"),
            "right",
            _DRIVE,
            of_machine=_OF_MACHINE,
        ),
        Formula("(2)", N_("force in the rod, Q′ = Q/sin(α₁ − β)"), "right", _DRIVE, of_machine=_OF_MACHINE),
        Formula(
            "(3)", N_("tangential force at the crank pin, T = Q′ sin(α − β)"), "right", _DRIVE, of_machine=_OF_MACHINE
        ),
        Formula(
            "(4)",
            N_("the same from the load, T = Q sin(α − β)/sin(α₁ − β)"),
            "right",
            _RATIO,
            N_("no losses, no inertia"),
            N_("exact; with the length of the load's arm it is the torque factor of `run`"),
        ),
        Formula("(5)", N_("velocities of the pins by the instant centre C"), "right", _CENTRES),
        Formula("(6)", N_("equal powers, Q v_A = T v_B"), "right", _RATIO, N_("no losses, no inertia")),
        Formula("(7)", N_("ratio of the pins' velocities, v_A/v_B = AC/BC"), "right", _CENTRES),
        Formula("(8)", N_("T = Q v_A/v_B"), "right", _RATIO, N_("no losses, no inertia")),
        Formula("(9)", N_("T = Q AC/BC"), "right", _RATIO, N_("no losses, no inertia")),
        Formula("(10)", N_("AC/BC = sin(α − β)/sin(α₁ − β)"), "right", _RATIO, note=N_("exact")),
        Formula("(11)", N_("sine of the angle BAC, proof of (10)"), "right", _DRIVE, of_machine=_OF_MACHINE),
        Formula(
            "(12)",
            N_("static torque on the crank's shaft, T r/η"),
            "right in a range",
            _DRIVE,
            _LOSSES,
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(13)",
            N_("the same from the load, with r₁"),
            "wrong",
            _DRIVE,
            note=N_("by (12) and (4) it has r, the crank's radius, not r₁"),
            of_machine=_OF_MACHINE,
        ),
        Formula("(14)", N_("static torque at the motor"), "right in a range", _DRIVE, _LOSSES, of_machine=_OF_MACHINE),
        Formula("(15)", N_("weight of the driven parts at A, GD²/(2r₁)²"), "right", _DRIVE, of_machine=_OF_MACHINE),
        Formula("(16)", N_("equal kinetic energies at A and B"), "right", _DRIVE, of_machine=_OF_MACHINE),
        Formula("(17)", N_("weight at B, by the square of (10)"), "right", _RATIO),
        Formula(
            "(18)",
            N_("flywheel moment at the crank's shaft"),
            "right",
            _DRIVE,
            N_("the rod without mass"),
            N_("with [masses] the result flywheel_moment is that of all bodies, the rod's too"),
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(19)",
            N_("the same with losses"),
            "wrong",
            _DRIVE,
            note=N_("an efficiency is no property of an inertia: losses follow the torque"),
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(20)",
            N_("flywheel moment at the motor"),
            "wrong",
            _DRIVE,
            note=N_("the moments go down by i², not i; and by no efficiency"),
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "(21)",
            N_("torque of idle running with a constant Q"),
            "right in a range",
            _DRIVE,
            N_("a weight or a spring: friction reverses with the rocker, and its torque never changes sign"),
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "fig. 2",
            N_("torque and flywheel moment over the crank angle"),
            "right in a range",
            _DRAWN,
            N_("as (20), (21)"),
            N_("redrawn with right, printed and refuted curves, of a machine file, too"),
            of_machine=_DRAWN_OF_MACHINE,
        ),
        Formula(
            "after (20)",
            N_("AC/BC of Kunitsky and Popov, the product of both sines, which the text refutes"),
            "wrong",
            _RATIO,
            note=N_("(10) is right, by the sine rule in the triangle ABC"),
        ),
        Formula(
            "after (20)",
            N_("their force in the rod, torque and flywheel moment at the motor, with products for quotients"),
            "wrong",
            _DRIVE,
            note=N_("as the text shows: Q′ = Q sin(α₁ − β) put into (1) gives sin²(α₁ − β) = 1"),
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "after (21)",
            N_("idle torque of Kunitsky and Popov, a flat line, which the text refutes"),
            "wrong",
            _DRIVE,
            note=N_("it is 0 at the dead positions"),
            of_machine=_OF_MACHINE,
        ),
        Formula(
            "purpose",
            N_("transients: a start of the drive over time, by its motor's torque and its masses"),
            "right in a range",
            "cranktrain start tilting_table",
            N_("named, not given"),
            N_("M − M_st = J dω/dt + ½ω² dJ/dφ: GD² by the angle lacks the second term"),
        ),
        Formula(
            "purpose",
            N_("power of the motor: the smallest typical one that is enough"),
            "right",
            "cranktrain synthesise drive tilting_table",
            note=N_("named, not given; what governs on this example is the start at the worst angle"),
        ),
        Formula(
            "purpose",
            N_("load diagrams: torque and power of the motor over time and angle"),
            "right",
            "cranktrain plot tilting_table --sheet drive -o sheet.svg",
            note=N_("named, not given"),
        ),
    ),
)
