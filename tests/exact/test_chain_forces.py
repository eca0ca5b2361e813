"""Forces of random chains, all groups in any order, against rigid bodies with joints and multipliers."""

import numpy as np
import pytest
from tests.exact.test_chain_triad import STRUCTURE as TRIAD
from tests.exact.test_chain_triad import TURN, drawn
from tests.exact.test_kind_forces import circumstances, number, xy
from tests.multibody import FRAME, Multibody
from tests.virtual_work import torque_of_work

from cranktrain.linkage import Crank, LinkPoint, Pin
from cranktrain.linkage.forces import added, block_link, crank_link, swivel_slider_link
from cranktrain.mechanisms.chain.assembly import assembled
from cranktrain.mechanisms.chain.forces import chain_dynamics, chain_forces, chain_load
from cranktrain.mechanisms.chain.gaps import chain_gap, chain_gaps
from cranktrain.mechanisms.chain.groups import chain_moving, pin_of
from cranktrain.mechanisms.chain.kinematics import chain_made, chain_motion
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    Coordinates,
    CrankSize,
    MountStep,
    PinStep,
    PointStep,
    RodLegStep,
    SlideSize,
    SlideStep,
    Structure,
    SwivelSize,
    SwivelStep,
    TrammelSize,
    TrammelStep,
    YokeSize,
    YokeStep,
)

CLOSE = 1e-13
"""Of the largest force in a joint."""
N_STEPS = 6


def step_of(random, place, points, links):
    """Any group on any point or link that there is, and its size."""
    on, other = random.choice(points, 2, replace=False)
    shift, length, second = random.uniform(-0.1, 0.1), *random.uniform(0.5, 1.5, 2)
    direction, side = random.uniform(-np.pi, np.pi), random.choice([-1.0, 1.0])
    guide = f"s{place}"
    match random.choice(["pin", "slide", "swivel", "yoke", "trammel", "point"]):
        case "pin":
            return PinStep(on, other, f"rod{place}", f"rocker{place}", f"B{place}"), Pin(length, second, side)
        case "slide":
            return SlideStep(on, f"link{place}", guide, "C"), SlideSize(length, side, direction, shift)
        case "swivel":
            return SwivelStep(on, other, f"lever{place}", guide), SwivelSize(shift, side, 0.0)
        case "yoke":
            return YokeStep(on, guide, "O"), YokeSize(random.uniform(0.7, 2.4), direction, shift)
        case "trammel" if links:
            return TrammelStep(random.choice(links), guide, "C"), TrammelSize(shift, direction, shift, 1.0)
        case _ if links:
            return PointStep(random.choice(links), f"P{place}"), LinkPoint(length, direction)
    return step_of(random, place, points, links)


def new_names(step):
    """Points and links that a step adds."""
    match step:
        case PinStep():
            return [step.joint], [step.rod, step.rocker]
        case SlideStep():
            return [pin_of(step.slider)], [step.rod]
        case SwivelStep():
            return [], [step.guide]
        case YokeStep() | TrammelStep():
            return [pin_of(step.slider)], []
        case PointStep():
            return [step.point], []


def any_chain(seed, phi):
    """Two cranks, a fixed point, six groups that close well at the angle."""
    random = np.random.default_rng(seed)
    points, links, steps, sizes = ["C", "main.pin", "second.pin"], [], [], []
    cranks = CrankSize(random.uniform(0.1, 0.4), 0.0), CrankSize(random.uniform(0.1, 0.4), random.uniform(-3, 3))
    while len(steps) < N_STEPS:
        step, own = step_of(random, len(steps), points, links)
        structure = Structure(("main", "second"), ("C",), (*steps, step), "main")
        size = ChainSize(cranks, (Coordinates(0.7, 0.3),), (*sizes, own))
        with np.errstate(all="ignore"):
            gap = (
                np.abs(chain_gaps(structure, phi, size)[-1])
                if isinstance(step, TrammelStep)
                else (chain_gaps(structure, phi, size)[-1])
            )
            sizes_now = assembled(structure, size, {}).steps
            coordinates = [value for name in new_names(step)[0] for value in xy(chain_made(structure, phi, size)[name])]
        if gap > 0.1 * cranks[0].radius and np.all(np.abs(coordinates) < 5):
            steps.append(step)
            sizes.append(sizes_now[-1])
            points, links = points + new_names(step)[0], links + new_names(step)[1]
    sliders = [step.slider for step in steps if not isinstance(step, PinStep | PointStep)]
    output = random.choice([*sliders, *links])
    return Structure(("main", "second"), ("C",), tuple(steps), str(output)), ChainSize(
        cranks, (Coordinates(0.7, 0.3),), tuple(sizes)
    )


class Builder:
    """A chain's bodies and joints, from where everything is."""

    def __init__(self, structure, size, made, carried, joints):
        self.system, self.made, self.joints = Multibody(), made, joints
        self.bodies = dict.fromkeys(("O", *structure.fixed), FRAME)
        self.carried = dict(zip(chain_moving(structure), zip(*carried, strict=True), strict=True))
        for name, own in zip(structure.cranks, size.cranks, strict=True):
            self.bodies[pin_of(name)] = self.body(name, crank_link(made[pin_of(name)], Crank(own.radius)))
        main, *others = (self.bodies[name] for name in structure.cranks)
        self.system.pin("main_bearing", main, FRAME, (0, 0))
        for other in others:
            self.system.weld(other, main)
        for step, own in zip(structure.steps, size.steps, strict=True):
            getattr(self, type(step).__name__)(step, own)
        self.system.drive(main)

    def body(self, name, link):
        self.bodies[name] = self.system.body(link, *self.carried[name])
        return self.bodies[name]

    def at(self, point):
        return xy(self.made[point])

    def pin(self, point, link):
        self.system.pin(f"{point}/{link}", self.bodies[link], self.bodies[point], self.at(point))

    def guide(self, slider, direction):
        """A slider on a fixed guide; its friction is a load here."""
        name, point = f"guide/{slider}", pin_of(slider)
        self.bodies[point] = self.body(slider, block_link(self.made[point], direction))
        self.rub(name, self.bodies[slider], FRAME, self.at(point), direction)
        self.system.line(name, self.bodies[slider], FRAME, self.at(point), direction)

    def rub(self, name, one, other, place, direction):
        """Friction along a line is a load here, of both bodies."""
        along = np.array([np.cos(direction), np.sin(direction)])
        drag = (along @ self.joints[name][:2]) * along
        for body, force in ((one, drag), (other, -drag)):
            if body != FRAME:
                self.system.force(body, place, force)

    def PinStep(self, step, own):
        for link, start in ((step.rod, step.rod_from), (step.rocker, step.rocker_from)):
            self.body(link, self.made[link])
            self.pin(start, link)
        self.bodies[step.joint] = self.bodies[step.rod]
        self.pin(step.joint, step.rocker)

    def SlideStep(self, step, own):
        rod = self.body(step.rod, self.made[step.rod])
        self.pin(step.rod_from, step.rod)
        self.guide(step.slider, own.direction)
        point = pin_of(step.slider)
        self.system.pin(f"{point}/{step.slider}", self.bodies[step.slider], rod, self.at(point))

    def SwivelStep(self, step, own):
        guide = self.made[step.guide]
        slider = self.body(step.slider, swivel_slider_link(self.made[step.pin], guide))
        lever = self.body(step.guide, guide)
        self.pin(step.pin, step.slider)
        self.pin(step.pivot, step.guide)
        name, direction = f"{step.slider}/{step.guide}", np.arctan2(guide.sin, guide.cos)
        self.rub(name, lever, slider, self.at(step.pin), direction)
        self.system.line(f"-{name}", slider, lever, self.at(step.pin), direction)

    def YokeStep(self, step, own):
        self.guide(step.slider, own.direction)
        carrier, slider = self.bodies[step.pin], self.bodies[step.slider]
        direction = own.direction + own.slot_angle
        self.rub(f"{step.pin}/{step.slider}", slider, carrier, self.at(step.pin), direction)
        self.system.slot(f"-{step.pin}/{step.slider}", carrier, slider, self.at(step.pin), direction)

    def TrammelStep(self, step, own):
        self.guide(step.slider, own.direction)
        link, point = self.made[step.link], pin_of(step.slider)
        slider, direction = self.bodies[step.slider], np.arctan2(link.sin, link.cos)
        self.rub(f"{point}/{step.slider}", slider, self.bodies[step.link], self.at(point), direction)
        self.system.slot(f"{point}/{step.slider}", slider, self.bodies[step.link], self.at(point), direction)

    def TriadStep(self, step, own):
        link = self.body(step.link, self.made[step.link])
        for leg, size in zip(step.legs, own.legs, strict=True):
            if isinstance(leg, RodLegStep):
                self.bodies[leg.joint] = self.body(leg.rod, self.made[leg.rod])
                self.pin(leg.rod_from, leg.rod)
                self.pin(leg.joint, step.link)
                self.bodies[leg.joint] = link
            else:
                self.guide(leg.slider, size.direction)
                self.pin(pin_of(leg.slider), step.link)

    def PointStep(self, step, own):
        self.bodies[step.point] = self.bodies[step.link]

    def MountStep(self, step, own):
        self.bodies[step.point] = self.bodies[pin_of(step.slider)]


def alone(part):
    """Numbers for arrays of one, which a triad makes."""
    if isinstance(part, tuple):
        return type(part)(*map(alone, part)) if hasattr(part, "_fields") else tuple(map(alone, part))
    return np.asarray(part).item()


def assert_joints_and_torques(random, structure, size, phi, coefficient):
    dynamics = chain_dynamics(structure, lambda size: size)
    made = {name: alone(part) for name, part in chain_made(structure, phi, size).items()}
    senses = [np.sign(made[slider].first) for slider in dynamics.sliding]
    bodies, loads, conditions = circumstances(random, dynamics, senses, coefficient)
    carried, conditions = number(((*bodies,), (*loads,)), 0), number(conditions, 0)
    motion = alone(chain_motion(structure, phi, size))
    carried = carried[0], tuple(map(added, carried[1], chain_load(structure, motion, size, 500.0)))
    forces = chain_forces(structure, motion, size, *carried, conditions)
    by_work = torque_of_work(dynamics, motion, size, *carried, conditions, forces)
    joints = dict(zip((one.name for one in dynamics.reactions), forces.joints, strict=True))
    system = Builder(structure, size, made, carried, joints).system
    apart, largest = system.compare(joints, (forces.driving_torque, by_work), conditions)
    assert apart < CLOSE * largest


@pytest.mark.parametrize("seed", range(60))
def test_joints_and_torques(seed):
    random = np.random.default_rng(seed)
    phi = random.uniform(0, 2 * np.pi)
    assert_joints_and_torques(random, *any_chain(seed, phi), phi, 0.05 * (seed % 2))


HUNG = (
    PointStep("plate", "knuckle"),
    SlideStep("knuckle", "slave", "ram", "A"),
    MountStep("block", "lug"),
    SlideStep("lug", "link", "valve", "B"),
)
"""What hangs on a triad: a rod on its link, and one on its block."""


@pytest.mark.parametrize("seed", range(20))
def test_what_hangs_on_a_triad_loads_it(seed):
    random = np.random.default_rng(seed)
    size = drawn(random)
    while not np.all(chain_gap(TRIAD, TURN, size) > 0.01):
        size = drawn(random)
    hung = [LinkPoint(0.3, 0.7), SlideSize(4.0, 1.0, random.uniform(-3, 3), 0.1)]
    hung += [LinkPoint(0.2, 1.1), SlideSize(5.0, -1.0, random.uniform(-3, 3), -0.1)]
    structure = TRIAD._replace(steps=(*TRIAD.steps, *HUNG), output="ram")
    whole = size._replace(steps=(*size.steps, *hung))
    assert_joints_and_torques(random, structure, whole, random.uniform(0, 2 * np.pi), 0.05 * (seed % 2))
