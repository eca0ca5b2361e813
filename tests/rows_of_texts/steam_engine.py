"""Rows of the steam-engine text: of a ten-wheeler of the Great Northern, and of its valve's eccentric."""

import numpy as np
import pytest
from tests.rows_of_texts.kept import CLOSE, EXACT, PHI, argument, curve_of, moved, ran, row, same

import cranktrain as ct
from cranktrain.plans.constructions import construction
from cranktrain.plans.positions import position_plan, rescaled

ENGINE = "great_northern"


def sizes(piston="1cylinder"):
    place = next(one for one in ct.load(ENGINE).places if one.name == piston)
    return float(place.geometry.crank_radius), float(place.geometry.rod_length)


def of_run(piston="1cylinder"):
    """Displacement and its derivatives by whole degrees, at 0 of which the crank points along the cylinder."""
    names = ("piston_displacement", "piston_velocity_coefficient", "piston_acceleration_coefficient")
    found = ran(ENGINE, *names)
    return [getattr(found, name)[found.labels["piston"].index(piston)] for name in names]


def check_form(number, symbol, form):
    """A form's curve is what is printed, and beside it stands what `run` has."""
    order = ("S", "c/ω", "j/ω²").index(symbol)

    def check(_command, _typed):
        radius, rod = sizes()
        found = curve_of(moved(ENGINE), number, "1cylinder", symbol)
        same(found.values[:-1], form(PHI, radius, radius / rod))
        same(found.exact[:-1], of_run()[order])

    return check


row("A", "(333)")(check_form("(333)", "S", lambda phi, r, lam: r * (1 - np.cos(phi) + lam / 2 * np.sin(phi) ** 2)))
row("A", "(336)")(check_form("(336)", "c/ω", lambda phi, r, lam: r * (np.sin(phi) + lam / 2 * np.sin(2 * phi))))
row("A", "(337)")(check_form("(337)", "j/ω²", lambda phi, r, lam: r * (np.cos(phi) + lam * np.cos(2 * phi))))


@row("A", "S = R(1 − cos φ) + L(1 − √(1 − λ² sin² φ))")
def exact_root(_command, _typed):
    for symbol, wanted in zip(("S", "c/ω", "j/ω²"), of_run(), strict=True):
        same(curve_of(moved(ENGINE), "fig. 146", "1cylinder", symbol).values[:-1], wanted)


@row("A", "fig. 146")
def arcs(_command, _typed):
    found = construction(ct.load(ENGINE), "arc")
    same(found.displacement, of_run()[0][::30])
    same(found.displacement, found.exact_displacement)


@row("A", "(334)")
def projection(_command, _typed):
    radius, _rod = sizes()
    found = construction(ct.load(ENGINE), "projection")
    same(found.displacement, radius * (1 - np.cos(PHI[::30])))
    same(found.exact_displacement, of_run()[0][::30])


@row("A", "(335)")
def largest_difference(_command, _typed):
    """Exact it is the displacement at 90° less that of an infinitely long rod, R."""
    radius, rod = sizes()
    (found,) = (one for one in moved(ENGINE).numbered("(335)") if one.of == "1cylinder")
    assert found.value == pytest.approx(radius**2 / rod / 2, rel=EXACT)
    assert found.exact == pytest.approx(of_run()[0][90] - radius, rel=CLOSE)


@row("A", "fig. 147", 0)
def brix(_command, _typed):
    radius, rod = sizes()
    found = construction(ct.load(ENGINE), "brix")
    phi = PHI[::30]
    same(found.displacement, radius * (1 - np.cos(phi + np.arcsin(radius / rod / 2 * np.sin(phi)))))
    same(found.exact_displacement, of_run()[0][::30])


@row("A", "fig. 147", 1)
def brix_backward(_command, _typed):
    """Its angles give the displacement by Brix, the exact ones by `run`, between whose degrees it is interpolated."""
    radius, rod = sizes()
    found = construction(ct.load(ENGINE), "brix_backward")
    angle = found.angle
    same(radius * (1 - np.cos(angle + np.arcsin(radius / rod / 2 * np.sin(angle)))), found.displacement)
    displacement = np.interp(found.exact_angle, PHI, of_run()[0])
    same(displacement, found.exact_displacement, 1e-4)


@row("A", "eccentric")
def eccentric(_command, _typed):
    radius, rod = sizes("1valve")
    found = construction(ct.load(ENGINE), "arc", mechanism="1valve")
    phi = PHI[::30]
    same(found.displacement, radius * (1 - np.cos(phi)) + rod - np.sqrt(rod**2 - (radius * np.sin(phi)) ** 2), CLOSE)
    stroke = ran(ENGINE, "stroke").stroke[ran(ENGINE, "stroke").labels["piston"].index("1valve")]
    assert np.max(found.displacement) == pytest.approx(stroke, rel=CLOSE)


@row("A", "scale")
def scale(command, _typed):
    """At 1 : 40 the pins of the plan, read back, are where `run` has the piston."""
    whole = float(argument(command, "--scale").partition(":")[2])
    plan = rescaled(position_plan(ct.load(ENGINE), 12, mechanism="1cylinder"), 1e-3 * whole)
    pins = plan.drawing.positions
    along = np.hypot(*pins["B"]) * plan.scale
    same(np.max(along) - along, of_run()[0][::30])
