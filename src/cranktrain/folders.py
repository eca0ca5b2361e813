"""Members of a package that stand in folders of their own: known by name, imported when one is asked for."""

import sys
from collections.abc import Sequence
from functools import cache
from importlib import import_module
from typing import Any, Generic, TypeVar, overload

Member = TypeVar("Member")


@cache
def member_named(package: str, member: str, name: str) -> Any:
    """Give what a folder of a package declares; what holds it is sent to another process with its name alone."""
    return getattr(import_module(f"{package}.{name}"), member)


class Folders(Sequence[Member], Generic[Member]):
    """What the folders of a package declare, in an order: to go through them imports all, to name one imports that.

    Parameters
    ----------
    package : str
        In which the folders stand, as `cranktrain.fluids`.
    member : str
        What each declares, under this name.
    names : sequence of str
        Of the folders.

    Examples
    --------
    >>> fluids = Folders("cranktrain.fluids", "KIND", ("otto", "diesel"))
    >>> fluids.names, fluids.named("diesel").name, [kind.name for kind in fluids]
    (('otto', 'diesel'), 'diesel', ['otto', 'diesel'])
    """

    def __init__(self, package: str, member: str, names: Sequence[str]) -> None:
        self.names = tuple(names)
        self._package, self._member = package, member

    def named(self, name: str) -> Member:
        """Give what the folder of that name declares."""
        found: Member = member_named(self._package, self._member, name)
        return found

    @property
    def loaded(self) -> tuple[Member, ...]:
        """Give those that were asked for already, by anybody."""
        return tuple(self.named(name) for name in self.names if f"{self._package}.{name}" in sys.modules)

    @overload
    def __getitem__(self, place: int) -> Member: ...

    @overload
    def __getitem__(self, place: slice) -> Sequence[Member]: ...

    def __getitem__(self, place: int | slice) -> Member | Sequence[Member]:
        """Give one by its place, or some."""
        names = self.names[place]
        return self.named(names) if isinstance(names, str) else tuple(map(self.named, names))

    def __len__(self) -> int:
        """Count them."""
        return len(self.names)
