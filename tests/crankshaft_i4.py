"""The synthetic in-line four of `golden/crankshaft_I4`, from the numbers and the gas law that its case states."""

import numpy as np
from tests.reference_case import ReferenceCase

from cranktrain.questions.crankshaft.bending.shaft_loads import ShaftLoads
from cranktrain.questions.crankshaft.metal.pieces_of_throws import (
    WEB_RULES,
    ThrowGeometry,
    pieces_of_throws,
    webs_of_throws,
)
from cranktrain.questions.crankshaft.metal.sections import Material, round_section, web_section
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft, StraightSpans, Supports

CASE = ReferenceCase.load("crankshaft_I4")
MACHINE = CASE.machine
SIZES = {name: np.multiply(value, 1e-3) for name, value in MACHINE["throw_geometry_mm"].items()}
CENTRIFUGAL = MACHINE["centrifugal_force_N"]
RADIUS = MACHINE["crank_radius_mm"] * 1e-3
SPEED = MACHINE["speed_rpm"] * np.pi / 30
THROW_ANGLES = np.radians(MACHINE["throw_angles_deg"])
N = len(THROW_ANGLES)


def pressure(degrees):
    """Absolute pressure over a cylinder's own crank angle, which is 360 at its firing dead centre. [Pa]"""
    gas = MACHINE["gas"]
    ratio, compression = gas["rod_ratio"], gas["compression_ratio"]

    def volume(at):
        cos, sin = np.cos(np.radians(at)), np.sin(np.radians(at))
        return 1 / (compression - 1) + (1 - cos + (1 - np.sqrt(1 - (ratio * sin) ** 2)) / ratio) / 2

    def compressed(at):
        return gas["induction_pressure_MPa"] * (volume(180) / volume(at)) ** gas["compression_exponent"]

    def cosine(at):
        return (1 - np.cos(np.pi * np.clip(at, 0, 1))) / 2

    expanded = gas["pressure_ratio"] * compressed(360) * (volume(360) / volume(degrees)) ** gas["expansion_exponent"]
    since = np.maximum(degrees - gas["burn_start_deg"], 0) / gas["burn_duration_deg"]
    burnt = 1 - np.exp(-gas["wiebe_a"] * since ** (gas["wiebe_m"] + 1))
    closed = (1 - burnt) * compressed(degrees) + burnt * expanded
    blown = cosine((degrees - gas["exhaust_opening_deg"]) / gas["blowdown_deg"])
    exhaust, induction = gas["exhaust_pressure_MPa"], gas["induction_pressure_MPa"]
    drawn = cosine(degrees / 20)
    return 1e6 * np.where(
        degrees >= 180, (1 - blown) * closed + blown * exhaust, (1 - drawn) * exhaust + drawn * induction
    )


def pin_forces(degrees):
    """K inward and T with the rotation, of gas and reciprocating inertia, each of shape (throw, angle). [N]"""
    fired = np.ravel(MACHINE["firing_dead_centre_shaft_angle_deg"])[:, np.newaxis]
    own = (degrees - fired + 360) % 720
    angle, ratio = np.radians(own), RADIUS / (MACHINE["rod_length_mm"] * 1e-3)
    rod = np.arcsin(ratio * np.sin(angle))
    acceleration = np.cos(angle) + ratio * (np.cos(2 * angle) + ratio**2 * np.sin(angle) ** 4) / np.cos(rod) ** 3
    area = np.pi / 4 * (MACHINE["bore_mm"] * 1e-3) ** 2
    ambient = MACHINE["gas"]["ambient_MPa"] * 1e6
    inertia = MACHINE["reciprocating_mass_kg"] * RADIUS * SPEED**2 * acceleration
    force = (pressure(own) - ambient) * area - inertia
    return force * np.cos(angle + rod) / np.cos(rod), force * np.sin(angle + rod) / np.cos(rod)


def crankshaft():
    """Its shaft and bearings, one design."""
    span = SIZES["span"]
    material = Material(np.array([[MACHINE["E_N_per_mm2"] * 1e6]]), np.array([[MACHINE["G_N_per_mm2"] * 1e6]]))
    begins = np.arange(N) * span
    planes = begins[:, np.newaxis] + SIZES["web_mid_planes"]
    throws = ThrowGeometry(
        np.array([[0.0, N * span]]), planes[np.newaxis], np.full((1, N), RADIUS), -THROW_ANGLES[np.newaxis]
    )
    journal, pin = np.full((1, N + 1), SIZES["main_diameter"]), np.full((1, N), SIZES["crankpin_diameter"])
    webs = web_section(
        np.full((1, N, 2), SIZES["web_width"]),
        np.full((1, N, 2), SIZES["web_thickness"]),
        Material(*(value[..., np.newaxis] for value in material)),
    )
    return Crankshaft(
        pieces_of_throws(throws, round_section(journal, 0 * journal, material), round_section(pin, 0 * pin, material)),
        webs_of_throws(throws, webs, journal, pin, WEB_RULES[0]),
        Supports(
            np.arange(N + 1)[np.newaxis] * span,
            np.full((1, N + 1, 1, 1), 1e-3 / MACHINE["support_stiffness_N_per_mm"]) * np.eye(2),
            np.zeros((1, N + 1, 2)),
            np.zeros((1, N + 1)),
        ),
        StraightSpans(np.full((1, N), MACHINE["straight_beam_EI_Nmm2"] * 1e-6), np.full((1, N), np.inf)),
    )


def shaft_loads(degrees, balanced=0.0):
    """Forces on its pins and webs; counterweights take a part of a throw's rotating static moment."""
    normal, tangential = pin_forces(degrees)
    counterweight = balanced * (CENTRIFUGAL["rod"] + CENTRIFUGAL["pin"] + sum(CENTRIFUGAL["web"])) / 2
    piece, on_web, z, radius, angle, force = [], [], [], [], [], []
    for throw, own in enumerate(THROW_ANGLES):
        turned = own + np.radians(degrees)
        outward = np.array([np.sin(turned), np.cos(turned)])
        forward = np.array([np.cos(turned), -np.sin(turned)])
        piece += [2 * throw + 1, 2 * throw, 2 * throw + 1]
        on_web += [False, True, True]
        z += [throw * SIZES["span"] + at for at in (*SIZES["rod_planes"], *SIZES["web_mid_planes"])]
        radius += [RADIUS, RADIUS / 2, RADIUS / 2]
        angle += [-own] * 3
        rotating = CENTRIFUGAL["rod"] + CENTRIFUGAL["pin"] - normal[throw]
        force += [rotating * outward + tangential[throw] * forward]
        force += [(web - counterweight) * outward for web in CENTRIFUGAL["web"]]
    return ShaftLoads(
        np.array(piece),
        np.array(on_web),
        np.array(z)[np.newaxis],
        np.array(radius)[np.newaxis],
        np.array(angle)[np.newaxis],
        (np.pi / 2 - np.radians(degrees))[np.newaxis],
        np.array(force)[np.newaxis],
    )
