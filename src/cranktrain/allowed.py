"""What is allowed where pydantic refuses a value, by the type of its error; and which names a file may give."""

from typing import Annotated, TypeAlias

from pydantic import AfterValidator

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, _

_TABLE, _LIST = N_("must be a table"), N_("must be a list in [ ]")
_WHOLE, _NUMBER, _TRUTH = N_("must be a whole number"), N_("must be a number"), N_("must be true or false")
OTHERWISE = N_("is not allowed here")
ALLOWED = {
    "model_type": _TABLE,
    "model_attributes_type": _TABLE,
    "dict_type": _TABLE,
    "mapping_type": _TABLE,
    "tuple_type": _LIST,
    "list_type": _LIST,
    "int_type": _WHOLE,
    "int_from_float": _WHOLE,
    "float_type": _NUMBER,
    "finite_number": N_("must be a finite number"),
    "bool_type": _TRUTH,
    "string_type": N_("must be text in quotes"),
    "string_too_short": N_("must have at least {min_length} characters"),
    "string_too_long": N_("must have at most {max_length} characters"),
    "string_pattern_mismatch": N_("must match {pattern}"),
    "too_short": N_("must have at least {min_length} items"),
    "too_long": N_("must have at most {max_length} items"),
    "greater_than": N_("must be more than {gt}"),
    "greater_than_equal": N_("must be at least {ge}"),
    "less_than": N_("must be less than {lt}"),
    "less_than_equal": N_("must be at most {le}"),
    "multiple_of": N_("must be a multiple of {multiple_of}"),
    "none_required": N_("must be left out"),
    "frozen_instance": N_("must not be changed; make a new one"),
}

ELSEWHERE = {
    "flywheel": "[evenness] flywheel",
    **dict.fromkeys(("n", "rpm", "omega", "speed"), "[shaft.main] speed"),
    **dict.fromkeys(("throws", "spacing"), "[shaft.main] throws, spacing"),
    "cylinders": '[shaft.main] throws = ["0 deg", "180 deg"]',
    **{key: f"[mechanism] {key}" for key in ("kind", "stroke", "crank_radius", "rod_length", "offset")},
    **dict.fromkeys(("lambda", "λ"), "[mechanism] crank_to_rod_ratio"),
    **{key: f"[cylinder] {key}" for key in ("bore", "cycle", "firing_order", "compression_ratio", "clearance")},
    **dict.fromkeys(("epsilon", "ε"), "[cylinder] compression_ratio"),
    "double_acting": '[cylinder] chambers = ["head", "crank"]',
    **dict.fromkeys(("mass", "piston"), "[masses.piston] mass"),
    "rod": "[masses.rod] mass",
    "crank": "[masses.crank] mass",
    "motor": "[drive.motor] kind",
    **dict.fromkeys(("compressor", "indicator", "card"), "[gas] kind"),
    "counterweights": "[balance] counterweights",
}
"""Words that books and other programs have for what a machine file says in one of its tables, and what is written."""

_OF_FORMULAS = ("=", "+", "-", "@", "\t", "\r")
"""What a spreadsheet takes a cell of a CSV for a formula by, where it is the first character."""


def _no_formula(name: str) -> str:
    """Refuse a name that a spreadsheet would compute."""
    if name.startswith(_OF_FORMULAS):
        allowed = _("must not begin with =, +, - or @, which a spreadsheet takes for a formula")
        raise InputError([Problem("", name, allowed, _("begin with a letter"))])
    return name


Name: TypeAlias = Annotated[str, AfterValidator(_no_formula)]
"""Key of a table whose keys are names that a file gives, or takes up: they stand in CSV."""
