"""Forces of the kinds against rigid bodies with joints and multipliers, which know no mechanism.

Any masses, centroids anywhere, loads on every link, gravity, acceleration, friction: the solver is given each slider's
friction as a load, and must find the normal force that belongs to it.
"""

import numpy as np
import pytest
from tests.exact import geometries
from tests.exact.agreement import rows
from tests.multibody import FRAME, Multibody
from tests.virtual_work import torque_of_work

from cranktrain.linkage import Crank, CrankAndPivot, turned_link
from cranktrain.linkage.forces import (
    Body,
    Conditions,
    Drive,
    Friction,
    Gravity,
    Wrench,
    added,
    block_link,
    crank_link,
    slider_link,
    swivel_slider_link,
    turned_wrench,
)
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms.articulated_rod.forces import on_master_rod
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke
from cranktrain.mechanisms.slider_crank.forces import slider_crank_forces
from cranktrain.mechanisms.slider_crank.kinematics import slider_crank as slider_crank_motion

N = 40
CLOSE = 1e-13
"""Of the largest force in a joint: the solver's equations are conditioned like the machine, some hundreds here."""


def number(value, i):
    """One machine and angle of nested tuples of arrays."""
    if isinstance(value, tuple):
        parts = [number(part, i) for part in value]
        return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    return float(np.broadcast_to(value, (N, 1))[i, 0])


def xy(point):
    return np.array([point.x.value, point.y.value])


def wheel(motion, geometry):
    return crank_link(motion.pin, Crank(geometry.crank_radius))


def swivel_links(motion, geometry, guide):
    return wheel(motion, geometry), swivel_slider_link(motion.pin, guide), guide


LINKS = {
    "slider_crank": lambda motion, geometry: (
        wheel(motion, geometry),
        motion.rod,
        slider_link(motion.slider, geometry.offset),
    ),
    "crank_rocker": lambda motion, geometry: (wheel(motion, geometry), motion.rod, motion.rocker),
    "scotch_yoke": lambda motion, geometry: (
        wheel(motion, geometry),
        block_link(motion.pin, geometry.slot_angle),
        slider_link(motion.slider, geometry.offset),
    ),
    "oscillating_cylinder": lambda motion, geometry: swivel_links(motion, geometry, motion.cylinder),
    "slotted_lever": lambda motion, geometry: swivel_links(motion, geometry, motion.rocker),
    "articulated_rod": lambda motion, geometry: (motion.rod, slider_link(motion.slider, geometry.offset)),
}
"""What moves, in the order of `Dynamics.moving`."""


def slider_crank(system, motion, geometry, carried, joints):
    links = LINKS["slider_crank"](motion, geometry)
    slider = links[2]
    crank, rod, piston = (system.body(*each) for each in zip(links, *carried, strict=True))
    system.force(piston, xy(slider.origin), (joints["guide"].x, 0))
    system.pin("main_bearing", crank, FRAME, (0, 0))
    system.pin("crank_pin", rod, crank, xy(motion.pin))
    system.pin("wrist_pin", piston, rod, xy(slider.origin))
    system.line("guide", piston, FRAME, xy(slider.origin), 0.0)
    system.drive(crank)


def crank_rocker(system, motion, geometry, carried, joints):
    links = LINKS["crank_rocker"](motion, geometry)
    crank, rod, rocker = (system.body(*each) for each in zip(links, *carried, strict=True))
    system.pin("main_bearing", crank, FRAME, (0, 0))
    system.pin("crank_pin", rod, crank, xy(motion.pin))
    system.pin("joint", rocker, rod, xy(motion.joint))
    system.pin("pivot", rocker, FRAME, (geometry.ground_length, 0))
    system.drive(crank)


def scotch_yoke(system, motion, geometry, carried, joints):
    links = LINKS["scotch_yoke"](motion, geometry)
    slider = links[2]
    crank, block, ram = (system.body(*each) for each in zip(links, *carried, strict=True))
    along = np.array([np.cos(geometry.slot_angle), np.sin(geometry.slot_angle)])
    rubbing = (along @ joints["slot"][:2]) * along
    system.force(ram, xy(slider.origin), (joints["guide"].x, 0))
    system.force(ram, xy(motion.pin), rubbing)
    system.force(block, xy(motion.pin), -rubbing)
    system.pin("main_bearing", crank, FRAME, (0, 0))
    system.pin("crank_pin", block, crank, xy(motion.pin))
    system.line("-slot", block, ram, xy(motion.pin), geometry.slot_angle)
    system.line("guide", ram, FRAME, xy(slider.origin), 0.0)
    system.drive(crank)


def swivelled(part, slot, pivot):
    def build(system, motion, geometry, carried, joints):
        link = getattr(motion, part)
        links = swivel_links(motion, geometry, link)
        crank, block, lever = (system.body(*each) for each in zip(links, *carried, strict=True))
        along = np.array([link.cos, link.sin])
        drag = (along @ joints[slot][:2]) * along
        system.force(lever, xy(motion.pin), drag)
        system.force(block, xy(motion.pin), -drag)
        system.pin("main_bearing", crank, FRAME, (0, 0))
        system.pin("crank_pin", block, crank, xy(motion.pin))
        system.line(f"-{slot}", block, lever, xy(motion.pin), np.arctan2(link.sin, link.cos))
        system.pin(pivot, lever, FRAME, (geometry.ground_length, 0))
        system.drive(crank)

    return build


BUILDERS = {
    "slider_crank": slider_crank,
    "crank_rocker": crank_rocker,
    "scotch_yoke": scotch_yoke,
    "oscillating_cylinder": swivelled("cylinder", "guide", "trunnion"),
    "slotted_lever": swivelled("rocker", "slot", "pivot"),
}


def closing(draw):
    """N machines with a closing margin of five per cent and more, of some centimetres and more."""
    drawn = draw(20 * N, seed=3)
    radius = drawn.geometry[0].crank_radius if hasattr(drawn.geometry, "master") else drawn.geometry.crank_radius
    return rows(drawn.geometry, np.flatnonzero((drawn.margin[:, 0] > 0.05) & (radius[:, 0] > 0.03))[:N])


def yokes():
    random = np.random.default_rng(3)
    radius, offset = random.uniform(0.05, 0.5, (N, 1)), random.uniform(-0.1, 0.1, (N, 1))
    return ScotchYoke(radius, offset, random.uniform(0.6, 2.5, (N, 1)))


def swivels():
    radius, ground, offset, _ = closing(geometries.swivel_cranks)
    return CrankAndPivot(radius, ground, offset, np.sign(ground - radius))


GEOMETRIES = {
    "slider_crank": lambda: closing(geometries.slider_cranks),
    "crank_rocker": lambda: closing(geometries.crank_rockers),
    "scotch_yoke": yokes,
    "oscillating_cylinder": swivels,
    "slotted_lever": swivels,
    "articulated_rod": lambda: closing(geometries.articulated_rods),
}


def circumstances(random, dynamics, senses, coefficient):
    """Any bodies, loads and conditions for N machines."""

    def uniform(low, high):
        return random.uniform(low, high, (N, 1))

    bodies = [
        Body(uniform(0.5, 5), uniform(-0.3, 0.5), uniform(-0.3, 0.3), uniform(0.01, 0.5)) for _ in dynamics.moving
    ]
    loads = [Wrench(uniform(-900, 900), uniform(-900, 900), uniform(-90, 90)) for _ in dynamics.moving]
    drive, gravity = Drive(uniform(5, 30), uniform(-50, 50)), Gravity(uniform(-9, 9), uniform(-9, 9))
    friction = tuple(Friction(coefficient, sense) for sense in senses)
    return bodies, loads, Conditions(drive, gravity, friction)


def any_machines(name, coefficient):
    """Kind, geometry, motion, bodies, loads, conditions of N machines at any angle each."""
    random = np.random.default_rng(5)
    kind, geometry = KINDS.named(name), GEOMETRIES[name]()
    motion = kind.motion(random.uniform(0, 2 * np.pi, (N, 1)), geometry)
    senses = [np.sign(kind.named(motion, slider).first) for slider in kind.dynamics.sliding]
    bodies, loads, conditions = circumstances(random, kind.dynamics, senses, coefficient)
    return kind, geometry, motion, tuple(bodies), tuple(loads), conditions


@pytest.mark.parametrize("coefficient", [0.0, 0.15])
@pytest.mark.parametrize("name", BUILDERS)
def test_joints_and_torques(name, coefficient):
    kind, geometry, motion, bodies, loads, conditions = any_machines(name, coefficient)
    everything = kind.dynamics.forces(motion, geometry, bodies, loads, conditions)
    by_work = torque_of_work(kind.dynamics, motion, geometry, bodies, loads, conditions, everything)
    free = np.flatnonzero(np.isfinite(np.broadcast_to(everything.driving_torque, (N, 1))))
    assert len(free) >= (0.7 * N if coefficient else N)  # friction wedges some
    for i in free:
        one = number((motion, geometry, (bodies, loads), conditions, everything, by_work), i)
        joints = kind.dynamics.by_joint(one[4].joints)
        system = Multibody()
        BUILDERS[name](system, *one[:3], joints)
        apart, largest = system.compare(joints, (one[4].driving_torque, one[5]), one[3])
        assert apart < CLOSE * largest, i


def articulated_pair(system, motions, geometry, carried, joints, masters):
    """Master and slave in the master's axes."""
    own, motion = motions
    gamma, master = geometry.bank_angle, geometry.master
    piston = slider_link(own.slider, master.offset)
    slave_rod, slave_piston = (
        turned_link(link, -gamma) for link in (motion.rod, slider_link(motion.slider, geometry.offset))
    )
    links = crank_link(own.pin, Crank(master.crank_radius)), own.rod, piston, slave_rod, slave_piston
    crank, rod, slider, link, slave = (system.body(*each) for each in zip(links, *carried, strict=True))
    system.force(slider, xy(piston.origin), (masters["guide"].x, 0))
    system.force(slave, xy(slave_piston.origin), turned_wrench(joints["guide"]._replace(y=0.0), -gamma)[:2])
    system.pin("main_bearing", crank, FRAME, (0, 0))
    system.pin("crank_pin", rod, crank, xy(own.pin))
    system.pin("wrist_pin", slider, rod, xy(piston.origin))
    system.line("guide", slider, FRAME, xy(piston.origin), 0.0)
    system.pin("knuckle", link, rod, xy(slave_rod.origin))
    system.pin("slave.wrist_pin", slave, link, xy(slave_piston.origin))
    system.line("slave.guide", slave, FRAME, xy(slave_piston.origin), gamma)
    system.drive(crank)


@pytest.mark.parametrize("coefficient", [0.0, 0.1])
def test_master_and_slave(coefficient):
    """The master, loaded by its slave; and without friction, the slave's shares added to what the master has alone."""
    random = np.random.default_rng(5)
    kind, master_kind = KINDS.named("articulated_rod"), KINDS.named("slider_crank")
    geometry = GEOMETRIES["articulated_rod"]()
    angle = random.uniform(0, 2 * np.pi, (N, 1))
    own, motion = slider_crank_motion(angle, geometry.master), kind.motion(angle, geometry)
    masters_, slaves_ = (
        circumstances(random, one.dynamics, [np.sign(moved.slider.first)], coefficient)
        for one, moved in ((master_kind, own), (kind, motion))
    )
    conditions = masters_[2]
    turned_gravity = turned_wrench(Wrench(*conditions.gravity, 0.0), geometry.bank_angle)
    in_slaves_axes = slaves_[2]._replace(drive=conditions.drive, gravity=Gravity(turned_gravity.x, turned_gravity.y))
    bodies, loads = map(tuple, slaves_[:2])
    slave = kind.dynamics.forces(motion, geometry, bodies, loads, in_slaves_axes)
    own_bodies, own_loads = map(tuple, masters_[:2])
    knuckle = kind.dynamics.by_joint(slave.joints)["knuckle"]
    load = (own_loads[0], added(own_loads[1], on_master_rod(motion, geometry, knuckle)), own_loads[2])
    master = slider_crank_forces(own, geometry.master, own_bodies, load, conditions)
    alone = slider_crank_forces(own, geometry.master, own_bodies, own_loads, conditions)
    works = (
        torque_of_work(master_kind.dynamics, own, geometry.master, own_bodies, own_loads, conditions, alone),
        torque_of_work(kind.dynamics, motion, geometry, bodies, loads, in_slaves_axes, slave),
    )
    shared = alone.driving_torque + slave.driving_torque, sum(works)
    torques = (master.driving_torque,) if coefficient else (master.driving_torque, *shared)
    in_masters_axes = [turned_wrench(wrench, -geometry.bank_angle) for wrench in loads]
    carried = (*own_bodies, *bodies), (*own_loads, *in_masters_axes)
    for i in range(N):
        one = number(((own, motion), geometry, carried, slave.joints, master.joints), i)
        gamma, slaves = one[1].bank_angle, kind.dynamics.by_joint(one[3])
        masters = master_kind.dynamics.by_joint(one[4])
        joints = masters | {
            "knuckle": turned_wrench(slaves["knuckle"], -gamma),
            "slave.wrist_pin": turned_wrench(slaves["wrist_pin"], -gamma),
            "slave.guide": turned_wrench(slaves["guide"], -gamma),
        }
        system = Multibody()
        articulated_pair(system, one[0], one[1], one[2], slaves, masters)
        apart, largest = system.compare(joints, number(torques, i), number(conditions, i))
        assert apart < CLOSE * largest, i


def test_both_torques_agree():
    """To twelve digits of the largest that the turn has, with friction and without."""
    phi = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    for name in GEOMETRIES:
        random = np.random.default_rng(8)
        kind, geometry = KINDS.named(name), GEOMETRIES[name]()
        motion = kind.motion(phi, geometry)
        senses = [np.sign(kind.named(motion, slider).first) for slider in kind.dynamics.sliding]
        for coefficient in (0.0, 0.1):
            bodies, loads, conditions = circumstances(random, kind.dynamics, senses, coefficient)
            forces = kind.dynamics.forces(motion, geometry, bodies, loads, conditions)
            by_work = torque_of_work(kind.dynamics, motion, geometry, bodies, loads, conditions, forces)
            apart = np.abs(forces.driving_torque - by_work)
            scale = np.nanmax(np.abs(by_work), axis=-1, keepdims=True)
            assert np.nanmax(apart / scale) < 1e-12, name
            assert np.mean(np.isfinite(apart)) > (0.7 if coefficient else 0.9999), name
