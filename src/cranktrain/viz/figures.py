"""Numbers as pictures write them."""

import numpy as np

from cranktrain.motion import Array


def figure(value: float) -> str:
    """Write a number with five figures, and a true minus."""
    digits = max(0, 4 - int(np.floor(np.log10(abs(value))))) if abs(value) > 1e-9 else 0
    return _with_true_minus(f"{value:.{min(digits, 7)}f}")


def aligned(values: Array) -> list[str]:
    """Write numbers of a column with as many decimals as give the largest five figures, and a true minus."""
    most = float(np.nanmax(np.abs(values), initial=0.0))
    digits = max(0, 4 - int(np.floor(np.log10(most)))) if most > 1e-9 else 0
    return [_with_true_minus(f"{value:.{min(digits, 7)}f}") for value in values.tolist()]


def rounded(value: float) -> str:
    """Write a number with two decimals, and a true minus."""
    return _with_true_minus(f"{value:.2f}")


def _with_true_minus(text: str) -> str:
    return text.replace("-", "−") if float(text) != 0.0 else text.lstrip("-")
