"""Names of the program in words: `mean_piston_speed` is "mean piston speed" to people, in their language."""

from cranktrain.language import said as _


def spelled(name: str) -> str:
    """Write a name in words, as translators are given it."""
    return name.replace("_", " ")


def said_name(name: str) -> str:
    """Say a name in the reader's language; one that no translator was given stays as it is, without underscores."""
    return _(spelled(name))
