"""A moving picture of a machine's throws, one of each sort: a small GIF of one turn."""

from collections.abc import Callable, Iterator, Sequence
from io import BytesIO
from operator import methodcaller
from typing import Any

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics.ties import smallest_of
from cranktrain.panels.sheets.motion.sheet import drawn_scenes
from cranktrain.panels.throw_scene import Scene
from cranktrain.plans.vectors import pair
from cranktrain.viz.paper.page import Page, drawing_settings, fitting_scale
from cranktrain.viz.paper.sketch import Sketch, bounds_of
from cranktrain.viz.throw.beside import Bounds, arrangements, together
from cranktrain.viz.throw.mechanism import mechanism_sketch

_SIDE, _HEAD = 110.0, 8.0
"""Width of the picture, and the room above the mechanism. [mm]"""

_DOTS_PER_INCH = 110
_COLOURS = 32
_STILL = 2
"""Order of the uppermost lines that stand still."""

_SECONDS = 3.0
"""Time that a turn takes in the picture."""


def animation(result: Any, *, n_frames: int = 36, design: int = 0, piston: str | None = None) -> bytes:
    """Draw the moving mechanism; parameters as of `drawn_scenes`, and the number of frames over one turn.

    Returns
    -------
    bytes
        A GIF that plays for ever.
    """
    from PIL import Image

    scenes = drawn_scenes(result, design, piston)
    tried = np.arange(n_frames) * (360.0 / n_frames)
    angles = [float(a) for a in tried if all(scene.closing_angle(float(a)) == a for scene in scenes)]
    bounds = [_bounds(scene, angles[::3]) for scene in scenes]
    gap = 0.15 * float(np.max([one.high - one.low for one in bounds]))
    fits: list[tuple[float, tuple[Array, ...], Bounds]] = []
    for places, (low, high) in arrangements(bounds, gap):
        fits.append((fitting_scale(*pair(high - low), (_SIDE - 8.0, _SIDE - 8.0)), places, Bounds(low, high)))
    scale, places, (low, high) = smallest_of(fits, lambda fit: fit[0])
    size = pair((high - low) / scale + np.array([8.0, 8.0 + _HEAD]))
    origin = pair(4.0 - low / scale)

    def drawn(angle: float) -> Sketch:
        return together([mechanism_sketch(scene, angle, scale, is_plain=True) for scene in scenes], places)

    frames = [Image.fromarray(pixels).convert("RGB") for pixels in _frames(drawn, angles, (size, origin))]
    palette = frames[0].quantize(_COLOURS)
    reduced = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    content = BytesIO()
    pause = round(1000.0 * _SECONDS / n_frames)
    reduced[0].save(
        content, "GIF", save_all=True, append_images=reduced[1:], duration=pause, loop=0, disposal=1, optimize=False
    )
    return content.getvalue()


def _bounds(scene: Scene, angles: Sequence[float]) -> Bounds:
    """Between what corners a throw moves. [mm]"""
    some = [mechanism_sketch(scene, angle, 1.0, is_plain=True) for angle in angles]
    return Bounds(*bounds_of(points for sketch in some for points in sketch.outline()))


def _frames(
    drawn: Callable[[float], Sketch],
    angles: Sequence[float],
    paper: tuple[tuple[float, float], tuple[float, float]],
) -> "Iterator[np.ndarray[tuple[int, ...], np.dtype[np.uint8]]]":
    """Draw frames as pixels: what stands still once, what moves with the same artists every time."""
    size, origin = paper
    with drawing_settings():
        page = Page(*size)
        page.figure.set_dpi(_DOTS_PER_INCH)
        still, moving = _parted(drawn(angles[0]))
        page.draw(still, origin)
        canvas: Any = page.figure.canvas
        canvas.draw()
        background = canvas.copy_from_bbox(page.figure.bbox)
        artists = page.draw(moving, origin)
        words = page.text(4.0, size[1] - 6.0, "")
        for angle in angles:
            canvas.restore_region(background)
            page.move(artists, _parted(drawn(angle))[1], origin)
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
