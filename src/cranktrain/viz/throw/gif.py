"""A moving picture of a machine's first throw: a small GIF of one turn."""

from collections.abc import Iterator, Sequence
from io import BytesIO
from operator import methodcaller
from typing import Any

import numpy as np

from cranktrain.analysis import Result
from cranktrain.plans.vectors import pair
from cranktrain.viz.paper.page import Page, drawing_settings, fitting_scale
from cranktrain.viz.paper.sketch import Sketch, bounds_of
from cranktrain.viz.throw.mechanism import mechanism_sketch
from cranktrain.viz.throw.scene import Scene, scene_of

_SIDE, _HEAD = 110.0, 8.0
"""Width of the picture, and the room above the mechanism. [mm]"""

_DOTS_PER_INCH = 110
_COLOURS = 32
_STILL = 2
"""Order of the uppermost lines that stand still."""

_SECONDS = 3.0
"""Time that a turn takes in the picture."""


def animation(result: Result, *, n_frames: int = 36, design: int = 0) -> bytes:
    """Draw the moving mechanism.

    Parameters
    ----------
    result : Result
    n_frames : int
        Over one turn.
    design : int
        Which of the result's machines.

    Returns
    -------
    bytes
        A GIF that plays for ever.
    """
    from PIL import Image

    machine = result.machines[design]
    scene = scene_of(machine)
    angles = [a for a in np.arange(n_frames) * (360.0 / n_frames) if scene.closing_angle(float(a)) == a]
    some = [mechanism_sketch(scene, angle, 1.0, is_plain=True) for angle in angles[::3]]
    low, high = bounds_of(points for sketch in some for points in sketch.outline())
    scale = fitting_scale(*pair(high - low), (_SIDE - 8.0, _SIDE - 8.0))
    size = pair((high - low) / scale + np.array([8.0, 8.0 + _HEAD]))
    origin = pair(4.0 - low / scale)
    frames = [Image.fromarray(pixels).convert("RGB") for pixels in _frames(scene, angles, scale, (size, origin))]
    palette = frames[0].quantize(_COLOURS)
    reduced = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    content = BytesIO()
    pause = round(1000.0 * _SECONDS / n_frames)
    reduced[0].save(
        content, "GIF", save_all=True, append_images=reduced[1:], duration=pause, loop=0, disposal=1, optimize=False
    )
    return content.getvalue()


def _frames(
    scene: Scene, angles: Sequence[float], scale: float, paper: tuple[tuple[float, float], tuple[float, float]]
) -> "Iterator[np.ndarray[tuple[int, ...], np.dtype[np.uint8]]]":
    """Draw frames as pixels: what stands still once, what moves with the same artists every time."""
    size, origin = paper
    with drawing_settings():
        page = Page(*size)
        page.figure.set_dpi(_DOTS_PER_INCH)
        still, moving = _parted(mechanism_sketch(scene, float(angles[0]), scale, is_plain=True))
        page.draw(still, origin)
        canvas: Any = page.figure.canvas
        canvas.draw()
        background = canvas.copy_from_bbox(page.figure.bbox)
        artists = page.draw(moving, origin)
        words = page.text(4.0, size[1] - 6.0, "")
        for angle in angles:
            canvas.restore_region(background)
            page.move(artists, _parted(mechanism_sketch(scene, float(angle), scale, is_plain=True))[1], origin)
            words.set_text(f"φ = {angle:g}°")
            for artist in (*sorted(artists, key=methodcaller("get_zorder")), words):
                page.paper.draw_artist(artist)
            yield np.asarray(canvas.buffer_rgba()).copy()


def _parted(sketch: Sketch) -> tuple[Sketch, Sketch]:
    """Part guides and paths, which lie below all links and stand still, from the rest."""
    return (
        Sketch(sketch.scale, [line for line in sketch.lines if line.order <= _STILL], []),
        Sketch(sketch.scale, [line for line in sketch.lines if line.order > _STILL], sketch.circles),
    )
