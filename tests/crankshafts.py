"""Crankshafts drawn at random: unequal spans, some throws in each, throws beyond the bearings, webs from pin to pin."""

import numpy as np

from cranktrain.questions.crankshaft.bending.shaft_loads import ShaftLoads
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft, Pieces, StraightSpans, Supports, Webs

STEEL, IN_SHEAR = 206e9, 79e9


def drawn_crankshaft(seed, n_angles=2, *, is_isotropic=None, n_spans=None):
    """A crankshaft on bearings with loads of all sorts, one design."""
    draw = np.random.default_rng(seed)
    n_spans = int(draw.integers(1, 4)) if n_spans is None else n_spans
    line = _Line(draw)
    line.journal(draw.uniform(0.02, 0.05))
    if draw.random() < 0.5:
        line.throw()
    bearings = [line.bearing()]
    for _span in range(n_spans):
        for _throw in range(int(draw.integers(1, 3))):
            line.throw(is_double=draw.random() < 0.3)
        bearings.append(line.bearing())
    if draw.random() < 0.5:
        line.throw()
    return line.shaft(np.array(bearings), n_spans, is_isotropic), line.loads(n_angles)


class _Line:
    """A shaft that is built piece by piece."""

    def __init__(self, draw):
        self.draw, self.bounds, self.radius, self.angle, self.places = draw, [0.0], [], [], []

    def journal(self, length):
        self._piece(length, 0.0, 0.0)

    def bearing(self):
        """A journal, or a longer one of the journal that is there, with a bearing on it; its place."""
        if self.radius[-1]:
            self.journal(self.draw.uniform(0.03, 0.08))
        begin, end = self.bounds[-2:]
        return begin + self.draw.uniform(0.8, 0.95) * (end - begin)

    def throw(self, *, is_double=False):
        """Pins, the second of which is joined to the first by a web, and the journal behind."""
        for _pin in range(2 if is_double else 1):
            self._piece(self.draw.uniform(0.03, 0.06), self.draw.uniform(0.02, 0.08), self.draw.uniform(-3, 3))
        self.journal(self.draw.uniform(0.03, 0.08))

    def _piece(self, length, radius, angle):
        begin, draw, piece = self.bounds[-1], self.draw, len(self.radius)
        self.bounds.append(begin + length)
        self.radius.append(radius)
        self.angle.append(angle)
        if radius or piece == 0:
            z = begin + draw.uniform(0.1, 0.6) * length
            self.places += [(piece, False, z, radius, angle), (piece, False, z + 1e-6 * length, radius, angle)]
        if piece:
            other, direction = (radius, angle) if radius else (self.radius[-2], self.angle[-2])
            share = draw.uniform(-1.2, 1.1)
            self.places.append(
                (
                    piece - 1,
                    True,
                    begin + draw.uniform(-3e-3, 3e-3),
                    abs(share) * other,
                    direction + (share < 0) * np.pi,
                )
            )

    def shaft(self, bearings, n_spans, is_isotropic):
        draw, n = self.draw, len(self.radius)
        diameter = draw.uniform(0.04, 0.07, n)
        area, second = np.pi / 4 * diameter**2, np.pi / 64 * diameter**4
        pieces = (STEEL * second, 2 * IN_SHEAR * second, 0.9 * IN_SHEAR * area, STEEL * area)
        width, height = draw.uniform(0.05, 0.1, n - 1), draw.uniform(0.01, 0.03, n - 1)
        webs = (
            STEEL * width * height**3 / 12,
            STEEL * height * width**3 / 12,
            IN_SHEAR * 0.3 * width * height**3,
            5 / 6 * IN_SHEAR * width * height,
            STEEL * width * height,
        )
        stiffness = np.array([self._stiffness(is_isotropic) for _bearing in bearings])
        supports = Supports(
            bearings[np.newaxis],
            np.linalg.inv(stiffness)[np.newaxis],
            draw.uniform(-2e-5, 2e-5, (1, len(bearings), 2)),
            draw.uniform(1e-5, 4e-5, (1, len(bearings))),
            int(draw.integers(0, len(bearings))),
        )
        bending = draw.uniform(5e3, 2e4, (1, n_spans))
        return Crankshaft(
            Pieces(*(np.array(values)[np.newaxis] for values in (self.bounds, self.radius, self.angle, *pieces))),
            Webs(*(values[np.newaxis] for values in webs), draw.uniform(0, 0.006, (1, n - 1, 2))),
            supports,
            StraightSpans(bending, draw.choice([np.inf, 5e7], (1, n_spans))),
        )

    def _stiffness(self, is_isotropic):
        x, y = 10 ** self.draw.uniform(7, 9, 2)
        return x * np.eye(2) if is_isotropic else np.array([[x, 0.4 * np.sqrt(x * y)], [0.4 * np.sqrt(x * y), y]])

    def loads(self, n_angles):
        draw, n = self.draw, len(self.places)
        piece, on_web, z, radius, angle = (np.array(values) for values in zip(*self.places, strict=True))

        def curves(size, *shape):
            return draw.uniform(-size, size, (1, n, *shape, n_angles))

        return ShaftLoads(
            piece,
            on_web,
            z[np.newaxis],
            radius[np.newaxis],
            angle[np.newaxis],
            np.sort(draw.uniform(-3, 3, (1, n_angles))),
            curves(1e4, 2),
            curves(100.0, 2),
            curves(200.0),
            curves(1000.0),
        )
