"""Numbers of a slave on an articulated rod, beside its master's, and its cylinder's table of the machine file."""

from math import pi

from cranktrain.language import _
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.paths import quoted
from cranktrain.synthesis.knuckle_equations import slave_dead_centres, stroke_product
from cranktrain.synthesis.proposal import Number, ProposedTable, wanted
from cranktrain.synthesis.slider_crank_lengths import Lengths, stroke_of


def slave_numbers(rod: ArticulatedRod, master_ratio: float | None) -> tuple[Number, ...]:
    """Numbers of one slave; its compression ratio with the master's deck and chamber, where the master's is given.

    Parameters
    ----------
    rod : ArticulatedRod
        Of single numbers.
    master_ratio : float or None

    Returns
    -------
    tuple of Number
    """
    at = slave_dead_centres(rod)
    stroke, top = float(at.top - at.bottom), float(at.top)
    higher = top - master_top(rod.master)
    ratio = ()
    if master_ratio is not None:
        clearance = master_stroke(rod.master) / (master_ratio - 1) - higher
        ratio = (Number("compression_ratio", "ε", 1 + stroke / clearance, "1", _("Compression ratio")),)
    return (
        Number("knuckle_radius", "r", float(rod.knuckle_radius), "mm", _("Knuckle radius")),
        Number("articulation_angle", "ζ", float(rod.articulation_angle), "deg", _("Articulation angle")),
        Number("rod_length", "l", float(rod.rod_length), "mm", _("Articulated rod")),
        Number("stroke", "S", stroke, "mm", _("Stroke of the slave")),
        Number("top_shift", "ε_T", float(at.top_angle - rod.bank_angle), "deg", _("Shift of the top dead centre")),
        Number(
            "bottom_shift",
            "ε_B",
            float(at.bottom_angle - rod.bank_angle) - pi,
            "deg",
            _("Shift of the bottom dead centre"),
        ),
        Number("top_distance", "H", top, "mm", _("Piston pin from the shaft at the top")),
        Number("height_over_master", "H − H_m", higher, "mm", _("Piston pin above the master's at the top")),
        Number("stroke_product", "r(1 + r/l) sin ψ", float(stroke_product(rod)), "mm", _("What the stroke fixes")),
        *ratio,
    )


def cylinder_table(ratio: float | None, bore: float | None) -> tuple[ProposedTable, ...]:
    """Write the cylinders' table: the bore and the master's compression ratio, where there is either."""
    keys = {} if bore is None else {"bore": wanted(bore, "mm")}
    if ratio is not None:
        keys["compression_ratio"] = f"{{ value = {ratio!r}, note = {quoted(_('as wanted'))} }}"
    return (ProposedTable("cylinder", keys),) if keys else ()


def master_top(master: SliderCrank) -> float:
    """Distance of the master's piston pin from the shaft at its top. [m]"""
    reach = float(master.crank_radius + master.rod_length)
    return float((reach**2 - master.offset**2) ** 0.5)


def master_stroke(master: SliderCrank) -> float:
    """Stroke of the master. [m]"""
    return stroke_of(Lengths(float(master.crank_radius), float(master.rod_length), float(master.offset)))
