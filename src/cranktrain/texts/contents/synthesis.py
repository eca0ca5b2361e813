"""The synthesis of a slider-crank from stroke and pressure angle: formulas without numbers, one example."""

from cranktrain.language import N_
from cranktrain.texts.contents.text import Formula, Text

_STEPS = "cranktrain synthesise slider-crank --textbook"
_OWN = (
    'cranktrain synthesise slider-crank --stroke "160 mm" --pressure-angle "30 deg" --rod-length "270 mm" '
    '--mean-speed "6.3 m/s" -o own.svg'
)

_OF_MACHINE = (
    'cranktrain synthesise slider-crank --stroke "12 in" --rod-length "30 in" --mean-speed "1.8288 m/s" --friction 0.1'
)
"""The numbers of mill_engine, at its 180 rpm."""

_STEPS_OF_MACHINE = f'{_OF_MACHINE} --pressure-angle "12 deg" --textbook'

TEXT = Text(
    name="slider-crank-synthesis",
    title=N_("a slider-crank from stroke and pressure angle"),
    said_of=N_("dimensions that are sought, not a machine that there is"),
    letter="C",
    formulas=(
        Formula(
            "r = S/2",
            N_("crank radius from the stroke"),
            "right",
            _STEPS,
            N_("central mechanism"),
            of_machine=_STEPS_OF_MACHINE,
        ),
        Formula(
            "l = r/tg [α]",
            N_("rod from the permissible pressure angle"),
            "wrong",
            _STEPS,
            note=N_("l = r/sin [α]: the pressure angle is largest at 90°; and tan 30° is 0.577, not 0.3"),
            of_machine=_STEPS_OF_MACHINE,
        ),
        Formula(
            "plans",
            N_("the mechanism in twelve positions, two of them at φ = [α] and 180° + [α]"),
            "wrong",
            "cranktrain plot vaz_21213 --plan positions --at source -o positions.svg",
            note=N_("the limit is reached at 90° and 270°; the text says 60°, and draws 30° and 210° for it"),
        ),
        Formula(
            "Tц = 2S/v",
            N_("period of a turn from the mean slider speed"),
            "right",
            _STEPS,
            note=N_("rounded to 0.05 s, which makes every velocity 1.5 % too large"),
            of_machine=_STEPS_OF_MACHINE,
        ),
        Formula("ω = 2π/Tц", N_("angular speed of the crank"), "right", _STEPS, of_machine=_STEPS_OF_MACHINE),
        Formula(
            "x = r cos φ + [l² − (r sin φ)²]",
            N_("position of the slider"),
            "wrong",
            _STEPS,
            note=N_("the root over the bracket is lost"),
            of_machine=_STEPS_OF_MACHINE,
        ),
        Formula(
            "v = rω[φ + (r/2l) sin 2φ]",
            N_("velocity of the slider, two harmonics"),
            "wrong",
            _STEPS,
            N_("central mechanism; the text gives no λ"),
            N_("sin φ for φ; its sign is that of −dx/dt; exact, the velocity has all harmonics"),
            of_machine=_STEPS_OF_MACHINE,
        ),
        Formula(
            "table",
            N_("velocity of the slider at 0, 30, … 330°"),
            "wrong",
            _STEPS,
            note=N_("slips at 60° and 300°, in sin 2φ and the bracket at 150° and 210°; r/2l is 0.148, not 0.15"),
            of_machine=_STEPS_OF_MACHINE,
        ),
        Formula(
            "plans",
            N_("the same with its own numbers, l = 0.27 m, at the scale of the text, 4 mm/mm"),
            "right",
            _OWN,
            note=N_("of a rod of 270 mm the pressure angle is at most 17.2°"),
            of_machine=f"{_OF_MACHINE} -o mill.svg",
        ),
        Formula(
            "guide",
            N_("the slider's side force on its guide, and the friction there"),
            "right",
            'cranktrain synthesise slider-crank --stroke "160 mm" --pressure-angle "30 deg" --friction 0.1',
            note=N_("the reason that the text gives for [α], and does not compute: N/P = tan β/(1 − μ tan β)"),
            of_machine=_OF_MACHINE,
        ),
    ),
)
