"""What many parts of a page ask of one machine."""

from collections.abc import Callable, Hashable
from functools import partial, wraps
from typing import Concatenate, ParamSpec, TypeVar

from cranktrain.machine import Machine

Found = TypeVar("Found")
Asked = ParamSpec("Asked")


def found_once(
    find: Callable[Concatenate[Machine, Asked], Found],
) -> Callable[Concatenate[Machine, Asked], Found]:
    """Let what is found of a machine, and of arguments that can be keys, be found once a machine."""

    @wraps(find)
    def found(machine: Machine, *args: Asked.args, **named: Asked.kwargs) -> Found:
        what: Hashable = (find, args, tuple(named.items()))
        return machine.design.found(what, partial(find, machine, *args, **named))

    return found
