"""Packages that most questions do without: which extra has each, what needs them, and what is said where one lacks."""

from collections.abc import Iterator, Mapping
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from cranktrain.errors import InputError, Position, Problem
from cranktrain.language import N_, Words, _

EXTRAS: Mapping[str, tuple[str, ...]] = {
    "plot": ("matplotlib", "PIL"),
    "dataset": ("xarray", "pandas", "scipy"),
    "xlsx": ("openpyxl",),
    "cad": ("ezdxf",),
    "fast": ("numba", "scipy"),
    "store": ("zarr",),
    "cluster": ("distributed",),
    "web": ("fastapi", "uvicorn"),
}
"""Packages by the extra that has them, of two extras the first by which a user would know what it is for."""

_PICTURE = ("matplotlib",)
_OF_FILES: Mapping[str, tuple[tuple[str, ...], str | None]] = {
    ".png": (_PICTURE, None),
    ".svg": (_PICTURE, None),
    ".pdf": (_PICTURE, None),
    ".gif": (("matplotlib", "PIL"), None),
    ".dxf": (("ezdxf",), None),
    ".xlsx": (("openpyxl",), N_("write a .csv, with --decimal comma where spreadsheets have one")),
    ".nc": (("xarray", "scipy"), N_("write a .csv or .json")),
    ".zarr": (("zarr",), N_("write a .csv or .json")),
}
"""What files need by how their names end, and which others would do."""


def is_there(package: str) -> bool:
    """Whether a package is installed; it is not imported."""
    return find_spec(package) is not None


def installing(package: str) -> Words:
    """Say how to have a package."""
    extra = next(extra for extra, packages in EXTRAS.items() if package in packages)
    return f"pip install 'cranktrain[{extra}]'"


def imported(package: str, path: str, instead: Words | None = None) -> Any:
    """Import a package of an extra.

    Parameters
    ----------
    package : str
    path : str
        What was asked for that needs it.
    instead : Words, optional
        What would do without it.

    Raises
    ------
    InputError
        With how to have it, where it is not installed.
    """
    try:
        return import_module(package)
    except ModuleNotFoundError:
        raise InputError([Problem(path, None, _needs(package), _repair(package, instead))]) from None


def lacking(package: str, path: str) -> Iterator[Problem]:
    """Refuse what needs a package that is not installed, before anything is done for it; as `imported`."""
    if not is_there(package):
        yield Problem(path, None, _needs(package), installing(package))


def lacking_for(suffix: str) -> Iterator[Problem]:
    """Refuse a file whose name ends so where a package that it needs is not installed."""
    packages, instead = _OF_FILES.get(suffix, ((), None))
    package = next((one for one in packages if not is_there(one)), None)
    if package is not None:
        repair = _repair(package, instead and _(instead))
        yield Problem("", suffix, _needs(package), repair, position=Position("-o"))


def _needs(package: str) -> Words:
    return _("needs the package {package}", package=package)


def _repair(package: str, instead: Words | None) -> Words:
    install = installing(package)
    return install if instead is None else _("{install}, or {instead}", install=install, instead=instead)
