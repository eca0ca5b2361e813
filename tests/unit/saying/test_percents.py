import pytest

from cranktrain.saying.percents import percent


@pytest.mark.parametrize(
    ("error", "text"),
    [(0.0254, "2.54"), (0.001, "0.10"), (6.28e-5, "0.0063"), (1.2e-4, "0.012"), (5.1e-4, "0.051"), (-0.0202, "-2.02"),
     (1e-17, "0.00"), (-1e-17, "0.00"), (0.0, "0.00"), (float("nan"), "–"), (0.25, "25.00")],
)  # fmt: skip
def test_small_errors_keep_two_figures(error, text):
    assert percent(error) == text
