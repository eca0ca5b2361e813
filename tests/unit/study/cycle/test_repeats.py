"""How many times a cycle repeats itself, as plain Python: cylinders laid out by hand, alike and not."""

import numpy as np
import pytest

from cranktrain.study.cycle.given import ChamberNumbers, OfFluid, OfKind, Repeats
from cranktrain.study.cycle.likeness import of_repeats
from cranktrain.study.cycle.repeats import first_chambers, times_repeated

TURN = 2 * np.pi


class Engine:
    """Cylinders whose cranks stand at `phases` and which fire at `fires`, in parts of a turn; a cycle of `turns`."""

    def __init__(self, phases, fires, turns=2, masters=None):
        n = len(phases)
        every = np.arange(n)
        self.cycle = turns * TURN
        self.kind = OfKind(
            mechanism=every,
            piston=every,
            master=np.array(masters if masters else [-1] * n),
            joint=np.zeros((n, 0), dtype=np.intp),
            phase=TURN * np.array([phases]),
            ahead=np.stack([np.cos(TURN * np.array([phases])), np.sin(TURN * np.array([phases]))], axis=-1),
            geometry=np.tile([0.04, 0.13, 0.0], (1, n, 1)),
            bodies=np.tile([0.0, 0.0, 0.0, 0.0, 0.6, 0.04, 0.0, 0.003], (1, n, 1)),
            gravity=np.zeros((1, n, 2)),
        )
        firing = TURN * np.array([fires], dtype=float)
        alike = np.ones((1, n))
        self.room = ChamberNumbers(
            partner=np.stack([every, every], axis=-1),
            area=np.tile([0.005, 0.0], (1, n, 1)),
            start=5e-5 * alike,
            top=0.17 * alike,
            ambient=1e5 * alike,
            smallest=5e-5 * alike,
            largest=5e-4 * alike,
            firing=firing,
            least=np.mod(firing, TURN),
            greatest=np.mod(firing + np.pi, TURN),
            kink=np.zeros((1, n, 0)),
            sense=np.zeros(0),
            turn=np.zeros(0),
        )
        self.fluid = OfFluid(every, np.tile([1e5, 1.35, 1.28], (1, n, 1)))
        self.repeats = Repeats(
            *(np.zeros(n, dtype=np.intp) for _what in range(3)), np.zeros(n, dtype=bool), np.zeros(n, dtype=bool)
        )

    @property
    def times(self):
        alike = of_repeats([self.kind], self.room, [self.fluid])
        return times_repeated(0, alike, self.cycle, self.repeats)


def in_line(order, turns=2):
    """Cylinders in a row that fire in equal steps; the crank of each stands at its top where it fires."""
    fires = np.zeros(len(order))
    fires[np.array(order) - 1] = np.arange(len(order)) * turns / len(order)
    return Engine(np.mod(-fires, 1.0), fires, turns)


@pytest.mark.parametrize(
    ("order", "turns"), [((1, 3, 4, 2), 2), ((1, 5, 3, 6, 2, 4), 2), ((1, 2, 3), 1), ((1, 4, 2, 5, 3), 2), ((1, 2), 2)]
)
def test_alike_cylinders_that_fire_evenly_repeat_one_another(order, turns):
    engine = in_line(order, turns)
    assert engine.times == len(order)
    first_chambers(len(order), engine.repeats)
    assert engine.repeats.is_first.tolist() == [True] + [False] * (len(order) - 1)


def test_firing_in_pairs_is_half_as_many():
    engine = Engine([0.0, 0.0, 0.5, 0.5], [0.0, 0.0, 0.5, 0.5], turns=1)
    assert engine.times == 2
    first_chambers(2, engine.repeats)
    assert engine.repeats.is_first.sum() == 2


def test_uneven_firing_does_not():
    """A twin whose cranks stand together at one end repeats after a turn; with opposite cranks it never does."""
    assert Engine([0.0, 0.0], [0.0, 1.0]).times == 2
    assert Engine([0.0, 0.5], [0.0, 0.5]).times == 1


@pytest.mark.parametrize(
    ("what", "field", "place"),
    [
        ("kind", "geometry", (0, 2, 1)),
        ("kind", "bodies", (0, 2, 4)),
        ("kind", "phase", (0, 2)),
        ("room", "firing", (0, 2)),
        ("room", "area", (0, 2, 0)),
        *(("room", field, (0, 2)) for field in ("start", "top", "ambient", "smallest", "largest", "least", "greatest")),
        ("fluid", "numbers", (0, 2, 1)),
    ],
)
def test_one_number_that_differs_ends_it(what, field, place):
    engine = in_line((1, 3, 4, 2))
    values = getattr(getattr(engine, what), field)
    values[place] += 1e-9 * (values[place] or 1.0)
    assert engine.times == 1


def test_weight_that_pulls_one_of_them_ends_it():
    engine = in_line((1, 3, 4, 2))
    engine.kind.gravity[0, 2, 1] = -9.81
    assert engine.times == 1


def test_what_hangs_on_a_rod_goes_with_it():
    """Two masters half a turn apart, a slave on each; hung on the other one's rod it is another machine."""
    phases, fires = [0.0, 0.5, 0.1, 0.6], [0.0, 0.5, 0.9, 0.4]
    assert Engine(phases, fires, 1, [-1, -1, 0, 1]).times == 2
    assert Engine(phases, fires, 1, [-1, -1, 0, 0]).times == 1
