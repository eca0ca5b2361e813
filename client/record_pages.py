"""Pictures of pages for the documents, and a short recording: made in a browser from the service as it is now.

    python client/record_pages.py [FOLDER]

Writes page.png, web.png, design.png, gallery.png and web.gif, into docs/static unless another folder is named. Needs
Chromium, Playwright and Pillow, as the tests do.
"""

import sys
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.browser import browser
from tests.serving import served

import cranktrain as ct

DOCUMENTS = Path(__file__).parents[1] / "docs" / "static"

WIDTH, HEIGHT = 1440, 900
SMALL = 800
"""Width of the recording. [px]"""
COLOURS = 128
ANGLES = range(0, 720, 40)
"""Of a cycle of the recording. [deg]"""
PAUSE = 130
"""Between its pictures. [ms]"""


def main(folder: Path) -> None:
    """Take all of them."""
    with TemporaryDirectory() as scratch, browser() as chromium, served(Path(scratch)) as address:
        context = chromium.new_context(viewport={"width": WIDTH, "height": HEIGHT}, reduced_motion="reduce")
        page = context.new_page()
        stand_alone = Path(scratch) / "page.html"
        ct.run("3d12").view().save(stand_alone)
        open_page(page, f"{stand_alone.as_uri()}#tab=Largest+forces&phi=70")
        taken(page, folder / "page.png")
        open_page(page, f"{address}#machine=3d12&tab=Largest+forces&phi=70")
        taken(page, folder / "web.png")
        recorded(page, folder / "web.gif")
        page.get_by_role("button", name="All machines").click()
        page.locator("dialog .card").first.wait_for()
        page.wait_for_timeout(500)
        taken(page, folder / "gallery.png")
        open_page(context.new_page(), f"{address}#machine=vaz_21213&tab=Design&phi=70", "Design")
        designed(context.pages[-1])
        taken(context.pages[-1], folder / "design.png")


def open_page(page, address, tab="") -> None:
    """Open a page, and wait until all of it is there."""
    page.goto(address)
    page.locator(".answers tr").first.wait_for()
    page.locator(".facts label" if tab else ".to-mind li").first.wait_for(timeout=60_000)
    page.wait_for_timeout(500)


def designed(page) -> None:
    """Vary two numbers."""
    for place, path in enumerate(("bank.line.mechanism.stroke", "shaft.main.speed")):
        page.locator(".design .axis select").nth(place).select_option(path)
    chosen = page.locator(".facts input:checked")
    while chosen.count():
        chosen.first.uncheck()
    for name in ("largest_torque", "largest_side_force"):
        page.locator(f".facts input[value={name}]").check()
    page.locator(".design button[type=submit]").click()
    page.locator(".swept figure").first.wait_for(timeout=120_000)
    page.wait_for_timeout(500)


def picture_of(page) -> Image.Image:
    """What the page shows now."""
    return Image.open(BytesIO(page.screenshot())).convert("RGB")


def taken(page, path: Path) -> None:
    """Keep what a page shows, in few colours."""
    few = picture_of(page).quantize(256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    few.save(path, optimize=True)


def recorded(page, path: Path) -> None:
    """Turn the crank through a cycle, and keep it as a GIF."""
    slider = page.locator("input[type=range]")
    pictures = []
    for angle in ANGLES:
        slider.fill(str(angle))
        slider.blur()
        page.wait_for_timeout(40)
        whole = picture_of(page)
        pictures.append(whole.resize((SMALL, SMALL * HEIGHT // WIDTH), Image.Resampling.LANCZOS))
    first, *others = [
        one.quantize(COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE) for one in pictures
    ]
    first.save(path, save_all=True, append_images=others, duration=PAUSE, loop=0, optimize=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DOCUMENTS)
