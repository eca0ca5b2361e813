"""Pictures: sheets, plans, animations and DXF of a machine and its result. Nothing that computes imports them.

What draws a picture, such as `plan_forces`, is found by its record in `PICTURES`, and loaded when first asked for.
"""

from collections.abc import Callable
from typing import Any

from cranktrain.panels.sheets import PICTURES
from cranktrain.panels.sheets.motion import SHEET_QUANTITIES
from cranktrain.viz.output import save, save_animation

__all__ = ["PICTURES", "SHEET_QUANTITIES", "save", "save_animation"]


def __getattr__(name: str) -> Callable[..., Any]:
    for picture in PICTURES:
        if picture.home.endswith(f":{name}"):
            from cranktrain.viz.pictures import drawing_of  # only for who draws

            return drawing_of(picture)
    if name.startswith("_"):
        raise AttributeError(f"cranktrain.viz has no {name}")
    from cranktrain.quantities import nearest  # only after a mistake

    meant = nearest(name, __dir__())
    raise AttributeError(f"cranktrain.viz has no {name}" + (f"; did you mean {meant}?" if meant else ""))


def __dir__() -> list[str]:
    drawing = (picture.home.partition(":")[2] for picture in PICTURES)
    return sorted({*(name for name in globals() if name.startswith("__")), *__all__, *drawing})
