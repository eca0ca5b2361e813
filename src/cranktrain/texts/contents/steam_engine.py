"""The steam engine's text, § 10: (333) to (337), figs. 146 and 147."""

from cranktrain.language import N_
from cranktrain.texts.contents.text import Formula, Text

_MOTION = "cranktrain textbook great_northern --table"
_CENTRAL = N_("central mechanism, λ ≤ 0.3")

TEXT = Text(
    name="steam-engine",
    title=N_("motion of a steam engine's piston"),
    said_of=N_("central slider-cranks and eccentrics"),
    letter="A",
    of_machine="steam_engine",
    formulas=(
        Formula(
            "fig. 146",
            N_("the mechanism; the piston's place by arcs of the rod's length, from either dead centre: C and C′"),
            "right",
            "cranktrain plot great_northern --plan arc -o arc.svg",
            note=N_("exact, for an offset line of stroke too"),
        ),
        Formula(
            "S = R(1 − cos φ) + L(1 − √(1 − λ² sin² φ))",
            N_("the displacement before its root is taken to first order, A_M D + DC of fig. 146"),
            "right",
            f"{_MOTION} --full",
            N_("central mechanism"),
            N_("exact; in numbers off by rounding alone"),
        ),
        Formula(
            "(333)",
            N_("displacement S with two harmonics; plus from the head side, minus from the crank side"),
            "right in a range",
            _MOTION,
            _CENTRAL,
            N_("off by 0.10 % of the stroke at λ = 0.25, which steam engines have at most, 0.18 % at 0.3"),
        ),
        Formula(
            "(334)",
            N_("displacement with an infinitely long rod; by orthogonal projection of the crank pin, fig. 146"),
            "right in a range",
            "cranktrain plot great_northern --plan projection -o projection.svg",
            N_("central mechanism, λ < 0.1"),
            N_("at λ = 0.1 still off by 2.5 % of the stroke"),
        ),
        Formula(
            "(335)",
            N_("Z = λR/2, the largest difference of (333) and (334)"),
            "right",
            "cranktrain textbook great_northern --full",
            note=N_("of the exact displacement and (334) it is L − √(L² − R²), 1.6 % more at λ = 0.25"),
        ),
        Formula(
            "fig. 147",
            N_("Brix's construction: a ray from the pole P, OP = Z"),
            "right in a range",
            "cranktrain plot great_northern --plan brix -o brix.svg",
            _CENTRAL,
            N_(
                "off by 0.20 % of the stroke at λ = 0.25, twice as much as (333): not “accurate enough for so-called "
                "exact computations”"
            ),
        ),
        Formula(
            "fig. 147",
            N_("the same backwards, from the displacement to the angle"),
            "right in a range",
            "cranktrain plot great_northern --plan brix-backward -o backward.svg",
            _CENTRAL,
            N_("the angle is off by 0.32° at λ = 0.25"),
        ),
        Formula(
            "(336)",
            N_("velocity c with two harmonics; minus from the crank side"),
            "right in a range",
            _MOTION,
            _CENTRAL,
            N_("off by 0.26 % of the peak at λ = 0.25, 0.44 % at 0.3"),
        ),
        Formula(
            "(337)",
            N_("acceleration j with two harmonics, at constant speed; minus from the crank side"),
            "right in a range",
            _MOTION,
            _CENTRAL,
            N_("off by 0.66 % of the peak at λ = 0.25, 1.1 % at 0.3"),
        ),
        Formula(
            "eccentric",
            N_("the drive of the slide valve: the same mechanism, R its eccentricity"),
            "right",
            "cranktrain plot great_northern --plan arc --mechanism 1valve -o valve.svg",
            note=N_("all of the text holds of it with R its eccentricity; it leads or trails the crank"),
        ),
        Formula(
            "scale",
            N_("positions drawn so that 1 mm is μ of the machine, and read back times μ"),
            "right",
            "cranktrain plot great_northern --plan arc --scale 1:40 -o scale.svg",
            note=N_("the plan says its μ_l"),
        ),
    ),
)
