"""The sheet of a pumping unit: its curves as data, and that it is drawn with and without a rating."""

import numpy as np
import pytest
from matplotlib.text import Text

import cranktrain as ct
from cranktrain.panels.design import OneDesign
from cranktrain.panels.sheets.pumping.panels import card_panel, pumping_panels, rated_torque
from cranktrain.viz import sheet_pumping

UNIT = "pumping_unit_c57"
WITHOUT = {"pumping": {"card": "invented_card"}}


def test_net_torque_is_the_sum_of_its_parts():
    torques = list(pumping_panels(OneDesign(ct.run(UNIT), 0)))[-1]
    net, rod, weights, rated = (curve.values for curve in torques.curves)
    assert net == pytest.approx(rod + weights, rel=1e-12, abs=1e-9)
    assert rated == pytest.approx(57000 * 0.1129848290276, rel=1e-9)


def test_card_meets_its_permissible_load_where_the_torque_is_at_its_rating():
    result = ct.run(UNIT)
    shown = OneDesign(result, 0)
    panel = card_panel(shown)
    card, up, down = panel.curves
    assert card.values.max() == pytest.approx(8500 * 4.4482216152605)
    assert np.nanmin(up.values) < card.values.max() < panel.limits[1]
    assert np.all(np.diff(up.across) >= 0)
    assert np.all(np.diff(down.across) >= 0)
    over = np.asarray(result.gearbox_torque) > rated_torque(shown)
    up = np.asarray(result.torque_factor) > 0
    beyond = np.asarray(result.polished_rod_load) > np.asarray(result.permissible_load)
    assert np.array_equal(over[up], beyond[up])
    assert np.array_equal(over[~up], ~beyond[~up] & np.isfinite(result.permissible_load)[~up])


@pytest.mark.parametrize("paths", [{}, WITHOUT])
def test_is_drawn(paths):
    figure = sheet_pumping(ct.run(UNIT, set=paths))
    words = " ".join(text.get_text() for text in figure.findobj(Text))
    assert ("most going up" in words) is not bool(paths)
    assert ("No permissible loads" in words) is bool(paths)
