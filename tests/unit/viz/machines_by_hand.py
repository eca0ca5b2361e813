"""Four machines, each as its file and by hand: crank-rocker, slotted lever, scotch yoke, a toggle press as a chain."""

from typing import Any

import numpy as np
from mpmath import mp
from tests.unit.viz.by_hand import FRAME, Body, ByHand, Load, Pin, Slide, beside, direction, met

import cranktrain as ct


def _at(x: float, y: float = 0.0):
    return lambda _angle: (mp.mpf(x), mp.mpf(y))


_O = _at(0.0)


def _crank(radius: float):
    return lambda angle: (radius * mp.cos(angle), radius * mp.sin(angle))


def _against(torque: float, turned: Any):
    """A torque or force that resists what turns, or goes, by the crank angle."""
    return lambda angle: -torque * float(mp.sign(mp.diff(turned, angle)))


def tilting_table():
    """A force of 4000 N to the left of the rocker, at an arm of −0.5 m; rod off its line of pins; an example's file."""
    pin, pivot = _crank(0.25), _at(0.8)

    def joint(angle):
        return met(pin(angle), 0.7, pivot(angle), 0.5, 1)

    bodies = {
        "crank": Body(_O, lambda a: a, 40.0, 2.0),
        "rod": Body(beside(pin, joint, 0.33, 0.02), direction(pin, joint), 60.0, 3.2),
        "rocker": Body(pivot, direction(pivot, joint), 800.0, 50.0),
    }
    joints = {
        "main_bearing": Pin("crank", FRAME, _O),
        "crank_pin": Pin("crank", "rod", pin),
        "joint": Pin("rod", "rocker", joint),
        "pivot": Pin("rocker", FRAME, pivot),
    }

    def tangential(angle):
        turned = direction(pivot, joint)(angle)
        return -4000.0 * float(mp.sin(turned)), 4000.0 * float(mp.cos(turned))

    loads = [Load("rocker", beside(pivot, joint, -0.5), force=tangential)]
    return ct.load("tilting_table"), ByHand(bodies, joints, loads, 37.5 * np.pi / 30)


def slotted_lever():
    """A torque of 300 N·m against the lever."""
    pin, pivot = _crank(0.1), _at(0.25)
    turned = direction(pivot, pin)
    bodies = {
        "crank": Body(_O, lambda a: a),
        "block": Body(pin, turned, 2.0, 0.01),
        "rocker": Body(beside(pivot, pin, 0.12, 0.01), turned, 9.0, 0.2),
    }
    joints = {
        "main_bearing": Pin("crank", FRAME, _O),
        "crank_pin": Pin("crank", "block", pin),
        "slot": Slide("block", "rocker", pin, turned),
        "pivot": Pin("rocker", FRAME, pivot),
    }
    file = ct.Machine(
        shaft={"main": {"speed": "120 rpm"}},
        mechanism={"kind": "slotted_lever", "crank_radius": "100 mm", "ground_length": "250 mm"},
        masses={
            "block": {"mass": "2 kg", "along": "0 mm", "inertia": "0.01 kg*m^2"},
            "rocker": {"mass": "9 kg", "along": "120 mm", "across": "10 mm", "inertia": "0.2 kg*m^2"},
        },
        load={"work": {"on": "rocker", "torque": "300 N*m"}},
    )
    return file, ByHand(bodies, joints, [Load("rocker", pivot, torque=_against(300.0, turned))], 4 * np.pi)


def scotch_yoke():
    """A force of 1500 N against the slider."""
    pin = _crank(0.04)

    def slider(angle):
        return 0.04 * mp.cos(angle), mp.mpf(0)

    def level(_angle):
        return mp.mpf(0)

    resisting = _against(1500.0, lambda a: slider(a)[0])
    bodies = {
        "crank": Body(beside(_O, pin, 0.03), lambda a: a, 1.0, 0.01),
        "block": Body(pin, level),
        "piston": Body(slider, level, 4.0),
    }
    joints = {
        "main_bearing": Pin("crank", FRAME, _O),
        "crank_pin": Pin("crank", "block", pin),
        "slot": Slide("block", "piston", pin, lambda _a: mp.pi / 2),
        "guide": Slide("piston", FRAME, slider, level),
    }
    file = ct.Machine(
        shaft={"main": {"speed": "300 rpm"}},
        mechanism={"kind": "scotch_yoke", "crank_radius": "40 mm"},
        masses={
            "crank": {"mass": "1 kg", "along": "30 mm", "inertia": "0.01 kg*m^2"},
            "piston": {"mass": "4 kg"},
        },
        load={"work": {"on": "piston", "force": "1500 N"}},
    )
    loads = [Load("piston", slider, force=lambda a: (resisting(a), 0.0))]
    return file, ByHand(bodies, joints, loads, 10 * np.pi)


def toggle_press():
    """A force of 100 kN against the ram; what hangs on the knee hangs on the pitman, as in the file."""
    pin, pivot = _crank(0.05), _at(0.4, 0.25)

    def knee(angle):
        return met(pin(angle), 0.32, pivot(angle), 0.25, -1)

    def ram(angle):
        x, y = knee(angle)
        return mp.mpf("0.4"), y - mp.sqrt(mp.mpf("0.0625") - (x - mp.mpf("0.4")) ** 2)

    resisting = _against(1e5, lambda a: ram(a)[1])
    bodies = {
        "crank": Body(_O, lambda a: a),
        "pitman": Body(beside(pin, knee, 0.15), direction(pin, knee), 12.0, 0.1),
        "upper": Body(beside(pivot, knee, 0.12), direction(pivot, knee), 20.0, 0.15),
        "lower": Body(beside(knee, ram, 0.13, -0.01), direction(knee, ram), 18.0, 0.14),
        "ram": Body(ram, lambda _a: mp.mpf(0), 150.0),
    }
    joints = {
        "main_bearing": Pin("crank", FRAME, _O),
        "main.pin/pitman": Pin("crank", "pitman", pin),
        "C/upper": Pin("upper", FRAME, pivot),
        "knee/upper": Pin("pitman", "upper", knee),
        "knee/lower": Pin("pitman", "lower", knee),
        "ram.pin/ram": Pin("lower", "ram", ram),
        "guide/ram": Slide("ram", FRAME, ram, lambda _a: mp.pi / 2),
    }
    masses = {
        "pitman": {"mass": "12 kg", "along": "150 mm", "inertia": "0.1 kg*m^2"},
        "upper": {"mass": "20 kg", "along": "120 mm", "inertia": "0.15 kg*m^2"},
        "lower": {"mass": "18 kg", "along": "130 mm", "across": "-10 mm", "inertia": "0.14 kg*m^2"},
        "ram": {"mass": "150 kg", "along": "0 mm", "inertia": "0 kg*m^2"},
    }
    load = {"work": {"on": "ram", "force": "100 kN"}}
    file = ct.load("toggle_press").with_({"load": load, "masses": masses, "shaft": {"main": {"speed": "100 rpm"}}})
    return file, ByHand(bodies, joints, [Load("ram", ram, force=lambda a: (0.0, resisting(a)))], 100 * np.pi / 30)


MACHINES = {make.__name__: make for make in (tilting_table, slotted_lever, scotch_yoke, toggle_press)}
