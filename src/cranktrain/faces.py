"""What shows a thing stands above the thing: it is called by name, and loaded when it is first asked for."""

from collections.abc import Callable
from importlib import import_module
from typing import Any


def face(home: str) -> Callable[..., Any]:
    """Give a function that stands above its caller.

    Parameters
    ----------
    home : str
        module:function, below `cranktrain`.

    Returns
    -------
    callable

    Examples
    --------
    >>> face("one_line:short")("a rod of 320 mm", 9)
    'a rod of…'
    """
    module, _colon, name = home.partition(":")
    function: Callable[..., Any] = getattr(import_module(f"cranktrain.{module}"), name)
    return function
