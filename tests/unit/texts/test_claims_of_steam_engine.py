"""What the page of the steam engine's text says beside its errors, in 40 digits or by `run`."""

from functools import partial

import matplotlib.pyplot as plt
import mpmath as mp
import numpy as np
import pytest
from matplotlib.text import Text
from tests.texts_said import sentence

import cranktrain as ct
from cranktrain.plans.constructions import construction
from cranktrain.viz import PICTURES
from cranktrain.viz.pictures import drawing_of

said = partial(sentence, "steam-engine")


def test_the_largest_difference_of_the_exact_displacement():
    """L + R − √(L² − R²) at 90° less R."""
    words = said("L − √(L² − R²), 1.6 % more at λ = 0.25")
    with mp.workdps(40):
        rod = mp.mpf(4)
        off = [
            1 - mp.cos(a) + rod - mp.sqrt(rod**2 - mp.sin(a) ** 2) - (1 - mp.cos(a))
            for a in (mp.pi * step / 360 for step in range(361))
        ]
        assert max(off) == rod - mp.sqrt(rod**2 - 1)
        assert f"{float(100 * (max(off) * 8 - 1)):.1f} % more" in words


def test_arcs_of_the_rod_are_exact_for_an_offset_line_of_stroke():
    said("exact, for an offset line of stroke too")
    machine = ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "140 mm", "offset": "12 mm"}
    )
    angle = 55.0
    found = construction(machine, "arc", angles=[angle])
    with mp.workdps(40):
        start = mp.asin(mp.mpf(12) / 180)
        phi = mp.radians(angle)
        place = 40 * mp.cos(phi) + mp.sqrt(mp.mpf(140) ** 2 - (40 * mp.sin(phi) - 12) ** 2)
        displacement = 180 * mp.cos(start) - place
    assert 1e3 * float(np.ravel(found.displacement)[0]) == pytest.approx(float(displacement), rel=1e-12)


def test_a_valves_eccentric_leads_its_crank():
    said("all of the text holds of it with R its eccentricity; it leads or trails the crank")
    (valve,) = (one for one in ct.load("great_northern").places if one.name == "1valve")
    assert valve.kind.name == "eccentric"
    travel = ct.textbook.motion("great_northern")
    assert any(one.of == "1valve" for one in travel.numbered("(333)"))


def test_a_plan_says_its_scale():
    """1:40 is 40 mm for 1 mm, in the inches of the engine's file."""
    said("the plan says its μ_l")
    (picture,) = (one for one in PICTURES if one.name == "arc")
    drawn = drawing_of(picture)(ct.load("great_northern"), scale=40.0)
    drawn.canvas.draw()
    assert rf"$\mu_l$ = {40 / 25.4:.3f} in/mm" in [one.get_text() for one in drawn.findobj(Text)]
    plt.close(drawn)
