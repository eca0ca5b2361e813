"""Bolotin's text, §§ 2 and 3: opposed pistons and articulated rods, (I.11) to (I.13), figs. 1.3 and 1.4."""

from cranktrain.language import N_
from cranktrain.texts.contents.text import Formula, Text

_OPPOSED = "cranktrain textbook 10d100 --source bolotin --table"
_SLAVES = "cranktrain textbook 3d12 --source bolotin --table"

TEXT = Text(
    name="bolotin",
    title=N_("opposed pistons and articulated rods"),
    said_of=N_("opposed pistons, and slaves on articulated rods"),
    letter="D",
    of_machine="bolotin",
    authors=("Болотин",),
    formulas=(
        Formula(
            "p. 14",
            N_("lead Δ of the exhaust crank: 10–15° in engines that turn one way, 5–10° in those that reverse"),
            "right",
            "cranktrain textbook 10d100 --source bolotin",
            note=N_(
                "astern the lead is −Δ, and where it is more than the ports' heights give, the scavenge ports open "
                "first; with a machine's ports this is computed"
            ),
        ),
        Formula(
            "fig. 1.3",
            N_("а: scheme of an engine with two shafts that turn alike"),
            "right",
            "cranktrain plot 10d100 --plan scheme -o scheme.svg",
        ),
        Formula(
            "fig. 1.3",
            N_("б: of one whose shafts turn against each other"),
            "right",
            "cranktrain plot deltic --plan scheme --mechanism 1B -o triangle.svg",
            note=N_(
                "travel, velocity and acceleration of central mechanisms are alike in both; side forces change sign"
            ),
        ),
        Formula(
            "p. 15",
            N_("volumetric dead centres at half the lead, Δ/2 and π + Δ/2"),
            "wrong",
            "cranktrain textbook 10d100 --source bolotin",
            N_("exact where cranks and rods are equal"),
            N_("with unequal rods, which it calls usual, 0.24° and 0.40° off at λ = 0.20 and 0.30, Δ = 12°"),
        ),
        Formula(
            "(I.11)",
            N_("path, velocity and acceleration of the exhaust piston, two harmonics"),
            "right in a range",
            _OPPOSED,
            N_("central mechanism, a piston that faces its own shaft; the text gives no λ"),
            N_(
                "off as (333), (336), (337) are: 0.10, 0.26 and 0.66 % at λ = 0.25; of the far piston on one shaft, "
                "which side rods drive, λ has a minus sign"
            ),
        ),
        Formula(
            "(I.12)",
            N_("the same of the scavenge piston, Δ behind"),
            "right in a range",
            _OPPOSED,
            N_("as (I.11)"),
            N_("both together, at λ = 0.25 and Δ = 12°: 0.10 % of the travel"),
        ),
        Formula(
            "p. 17",
            N_("rods side by side on one pin, whose axes meet its own: every piston moves as on a plain crank"),
            "right",
            "cranktrain textbook kamaz_740 --source steam-engine",
        ),
        Formula(
            "fig. 1.4",
            N_("scheme of a master and its slave on an articulated rod"),
            "right",
            "cranktrain plot 3d12 --plan scheme -o slave.svg",
        ),
        Formula(
            "(I.13)",
            N_("path, velocity and acceleration of the slave piston, two harmonics"),
            "right in a range",
            _SLAVES,
            N_("the text gives none; γ in the sense of rotation, no offset"),
            N_("of the example 3d12 off by 0.35 % of the stroke, 0.94 % in v, 2.40 % in j"),
        ),
        Formula(
            "(I.13)",
            N_("the constants K, E, F, Φ, Θ"),
            "right in a range",
            "cranktrain textbook 3d12 --source bolotin",
            N_("cos ψ → 1; F/sin Θ fails at γ = 0"),
            N_("illegible in the copies at hand: reconstructed, and derived anew beside that"),
        ),
        Formula(
            "p. 19, 1",
            N_("the slave's stroke is larger than the master's: М-50 209.8, 40Д 304.3, 3Д12 186.7 mm"),
            "wrong",
            "cranktrain run 3d12 --quantities stroke",
            N_("true of the three engines named"),
            N_(
                "no law: on the proportions often quoted for 3Д12 the strokes are equal at ζ = 59.8°, the slave's "
                "smaller below; and with ζ = 67° these give 187.07 mm, not 186.7"
            ),
        ),
        *(
            Formula(
                "p. 19, 1",
                subject,
                "right",
                f"cranktrain run {example} --quantities stroke",
                note=N_("by rods that are fitted to it: one stroke does not fix three sizes"),
            )
            for subject, example in (
                (N_("stroke of the slaves of М-50, 209.8 mm beside 200 mm"), "m_50"),
                (N_("stroke of the slaves of 40Д, 304.3 mm beside 300 mm"), "40d"),
            )
        ),
        Formula(
            "p. 19, 1",
            N_("so the power differs from bank to bank"),
            "right",
            "cranktrain run 3d12 --quantities bank_indicated_power",
            note=N_("4.9, 1.4 and 3.7 % more swept volume in the slaves' bank of М-50, 40Д and 3Д12"),
        ),
        Formula(
            "p. 19, 2",
            N_("the slave's dead centres are shifted from where the crank lies along its cylinder"),
            "right",
            "cranktrain run 3d12 --quantities top_shift,bottom_shift",
            note=N_("none at the top if ζ = γ + asin(λ sin γ), none at the bottom with minus; never both"),
        ),
    ),
)
