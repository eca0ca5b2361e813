"""What each key of the machine file is, in one sentence, for editors and forms."""

from cranktrain.language import N_, _
from cranktrain.spec import Spec

_SENTENCES = {
    "Machine": {
        "name": N_("Name of the machine, as tables and plots show it."),
        "rotation": N_(
            "Normal sense of rotation, seen from the free end of the shaft; all angles of the file count in it."
        ),
        "running": N_("`astern` is the same machine turning against its normal sense of rotation."),
        "crank_zero": N_(
            "Crank angle that is shown as 0, or `Y`: where throw 1 points up; otherwise 0 is along the first bank."
        ),
        "angle": N_("Direction of the mechanism's x axis, from straight up; for a machine with one [mechanism]."),
        "shaft": N_("Shafts by name; the angle of `main` is the crank angle."),
        "mechanism": N_("The mechanism of a machine that has only one; otherwise each bank has its own."),
        "bank": N_("Banks by name; the first one in the file is the first bank."),
        "masses": N_(
            "Bodies by the part that they are: piston, rod, crank, a chain's own names; a bank may have its own."
        ),
        "friction": N_(
            'Coefficients of friction by what slides: piston, block, or a chain\'s slider S and its slot, "S.slot".'
        ),
        "guide": N_("Guides of what slides, by the names of [friction]: how long they are; a bank may have its own."),
        "gravity": N_("Whether weights count, downward; or a table, for another strength or direction."),
        "gas": N_("What the chambers hold: the kind of gas model and its numbers."),
        "cylinder": N_("Cylinders: what is common to all, and tables for one bank or one cylinder."),
        "evenness": N_("What balances the machine, its flywheel, and how evenly it is to run."),
        "balance": N_("Counterweights and balance shafts, given or solved for."),
    },
    "GravitySpec": {
        "acceleration": N_("Of free fall in the mechanism's plane; 9.80665 m/s² unless given."),
        "direction": N_("How far it is turned from straight down, −Y, in the normal sense of rotation."),
    },
    "BalanceSpec": {
        "weight": N_("Weights that turn: on the crankshaft, or on shafts of their own."),
        "counterweights": N_(
            "Solved for: `rotating` takes all that rotates on each throw, `least_force` leaves the least largest force."
        ),
        "share": N_("Share of what reciprocates that counterweights take besides all that rotates: 0 unless given."),
        "planes": N_("Two places along the shaft, from throw 1, for the counterweights; unless given, every throw."),
        "shafts": N_("Pairs of balance shafts, solved for after all other weights."),
    },
    "WeightSpec": {
        "mass": N_("Mass of the weight."),
        "radius": N_("Of its centroid from the axis of its shaft."),
        "angle": N_(
            "Where it stands at crank angle 0 of throw 1, ahead of throw 1; on a throw, opposite that unless given."
        ),
        "throw": N_("The throw of the crankshaft that it is on, counted from 1."),
        "z": N_("Its place along the shaft, from throw 1 toward the flywheel."),
        "ratio": N_("Turns for one of the crank, less than 0 against it; 1 unless given."),
        "place": N_("Where its shaft lies from the crankshaft's centre: to the right, and up."),
    },
    "BalanceShaftsSpec": {
        "order": N_("How many times as fast as the crank both shafts turn."),
        "against": N_("Whether they take away the force of that order, the couple, or both."),
        "planes": N_("Places of their weights along the shaft, from throw 1: one against a force, two for a couple."),
        "forward": N_("Where the shaft lies that turns with the crank: to the right of its centre, and up."),
        "backward": N_("Where the shaft lies that turns against the crank: to the right of its centre, and up."),
    },
    "ShaftSpec": {
        "throws": N_("How far each throw stands ahead of throw 1; one that is to fire later stands behind."),
        "spacing": N_("Distance between neighbouring throws along the shaft, or a list of all; 0 for a split pin."),
        "speed": N_("Mean speed of the shaft; with it, velocities and accelerations."),
        "speed_curve": N_("Speed over the crank angle in a file: at it everything is computed."),
        "acceleration": N_(
            "Angular acceleration beside the speed, in the sense of running: all results are then of one moment."
        ),
        "ratio": N_("Of a shaft geared to `main`: 1 where it turns with it, -1 where it turns against it."),
        "phase": N_(
            "Of a shaft geared to `main`: where its throw 1 stands at crank angle 0, ahead of throw 1 of `main`;"
            " unless given, the lead of opposed pistons says so."
        ),
        "place": N_("Where the shaft's centre lies from that of `main`: to the right, and up; with it, it is drawn."),
    },
    "BankSpec": {
        "angle": N_("From straight up to the bank's line of stroke, in the sense of rotation; a list makes a star."),
        "mechanism": N_(
            "The mechanism of each cylinder; with a list of angles, a field may be a list, one value for each."
        ),
        "throws": N_("Throws on which the bank works, counted from 1; all unless given."),
        "shaft": N_("The shaft that the bank works on."),
        "stagger": N_("By how much the bank is moved along the shaft toward the flywheel."),
        "exhaust": N_("With opposed pistons: the piston of each cylinder that uncovers the exhaust ports."),
        "scavenge": N_("With opposed pistons: the piston of each cylinder that uncovers the scavenge ports."),
        "masses": N_("Bodies of this bank's mechanisms, where they are not those of all."),
        "guide": N_("Guides of this bank's mechanisms, where they are not those of all."),
        "lead": N_("By how much the exhaust crank is ahead of the scavenge crank; it phases their shafts."),
    },
    "BodySpec": {
        "mass": N_("Mass of the body; or, of a rod, those of both its ends."),
        "along": N_("Centroid's distance from the link's first pin, toward its second."),
        "across": N_("Centroid's distance from the link's line, to its left."),
        "inertia": N_("Moment of inertia about the centroid; of a rod, that of two masses at its ends unless given."),
        "big_end": N_("Mass at the rod's first pin, as weighed."),
        "small_end": N_("Mass at the rod's second pin, as weighed."),
    },
    "GuideSpec": {
        "length": N_("Between the guide's outer edges, along it: a skirt's, a shoe's, a bush's."),
        "middle": N_(
            "Where its middle lies from the slider's pin, ahead as the slider's position counts; 0 unless given."
        ),
        "at": N_(
            "Instead of middle, of edges that stand still, such as a bush's: the slider's position in the middle."
        ),
    },
    "OpposedPistonSpec": {
        "masses": N_("Bodies of this piston's mechanism, where they are not those of all."),
        "guide": N_("Guides of this piston's mechanism, where they are not those of all."),
        "mechanism": N_("The mechanism of the piston."),
        "shaft": N_("The shaft that the piston works on."),
        "throws": N_("Throws on which the bank's pistons work, counted from 1; all unless given."),
        "side_rods": N_("On a shaft that both pistons share: whether this one is the far one, driven by side rods."),
    },
    "CylinderSpec": {
        "bore": N_("Diameter of the cylinder."),
        "compression_ratio": N_(
            "Largest volume over smallest, by the true stroke; a cylinder without its own has the first one's deck."
        ),
        "exhaust_port": N_("Height of the exhaust ports, open where the piston is at its outer dead centre."),
        "scavenge_port": N_("Height of the scavenge ports, open where the piston is at its outer dead centre."),
        "chambers": N_(
            'Sides of the piston that work: ["head", "crank"] is double-acting; the head\'s alone unless given.'
        ),
        "piston_rod": N_("Diameter of the piston rod, which takes up room on the crank's side."),
    },
    "CylindersSpec": {
        "cycle": N_("Strokes of one working cycle; the crank angle runs through one or two turns."),
        "firing_order": N_(
            'Cylinders in the order in which they fire, such as "1-3-4-2"; with the cycle: firing angles.'
        ),
        "firing_angles": N_(
            "Crank angles at which the cylinders fire, as shown, instead of an order: a list, one for each cylinder in "
            'the order of the file, or by name, { 1L = "0 deg", 1R = "60 deg" }.'
        ),
        "numbers": N_('A maker\'s own numbers of the cylinders, for use in the firing order: { 5 = "1L" }.'),
        "mechanical_efficiency": N_(
            "Brake power over indicated power; of a driven machine the other way round. Or give friction_pressure."
        ),
        "friction_pressure": N_(
            "Work that friction takes in a cycle, over the displacement; it is no absolute pressure."
        ),
        "overrides": N_("What one bank or one cylinder has of its own."),
    },
    "MechanismSpec": {
        "kind": N_("Kind of mechanism."),
        "points": N_("Points on links to follow, by name."),
    },
    "LinkPointSpec": {
        "link": N_("The link that carries the point."),
        "along": N_("Distance from the link's first pin toward its second."),
        "across": N_("Distance from the line of pins, to the side turned 90° from it in the sense of rotation."),
    },
    "SliderCrankSpec": {
        "crank_radius": N_("From shaft centre to crank pin; or give the stroke."),
        "stroke": N_("True travel of the piston; or give the crank radius."),
        "rod_length": N_("From crank pin to piston pin; or give one of the ratios."),
        "crank_to_rod_ratio": N_("λ = R/L instead of the rod's length."),
        "rod_to_crank_ratio": N_("L/R instead of the rod's length."),
        "offset": N_("Of the line of stroke from the shaft, positive toward +y: 90° ahead of the stroke's direction."),
    },
    "CrankRockerSpec": {
        "crank_radius": N_("From shaft centre to crank pin."),
        "rod_length": N_("From crank pin to the joint of rod and rocker."),
        "rocker_length": N_("From the rocker's pivot to its joint with the rod."),
        "ground_length": N_("From shaft centre to the rocker's pivot."),
        "side": N_("Of the line from crank pin to pivot, on which the joint lies, seen in the sense of rotation."),
        "load_direction": N_("Whether the load's travel counts with the rocker's angle or against it."),
        "load_radius": N_("About the pivot, at which the load is carried; with it, its travel and the torque factor."),
    },
    "ScotchYokeSpec": {
        "crank_radius": N_("From shaft centre to crank pin."),
        "offset": N_("Of the line of stroke from the shaft, positive toward +y: 90° ahead of the stroke's direction."),
        "slot_angle": N_("From the line of stroke to the slot, in the sense of rotation."),
    },
    "OscillatingCylinderSpec": {
        "crank_radius": N_("From shaft centre to crank pin."),
        "ground_length": N_("From shaft centre to the trunnion about which the cylinder rocks."),
        "offset": N_("Of the cylinder's axis from the trunnion, to the left of its direction toward the crank pin."),
    },
    "SlottedLeverSpec": {
        "crank_radius": N_("From shaft centre to crank pin."),
        "ground_length": N_("From shaft centre to the lever's pivot; shorter than the crank, the lever turns."),
        "offset": N_("Of the slot's line from the pivot, to the left of its direction toward the crank pin."),
    },
    "ChainSpec": {
        "output": N_("Name of the slider or link that load and gas act on."),
        "fixed": N_("Fixed points by name: x and y in the file's own axes, from the shaft's centre."),
        "crank": N_("Cranks on the shaft: `main`, whose angle is the crank angle, and eccentrics."),
        "part": N_("Groups, each on what stands above it."),
    },
    "ChainCrankSpec": {
        "radius": N_("From shaft centre to pin."),
        "angle": N_("How far the eccentric stands ahead of the crank `main`."),
        "ratio": N_("Turns for one of the crank `main`: 1, as all cranks of a chain are on one shaft."),
    },
    "ChainLinkSpec": {
        "name": N_("Name of the link."),
        "start": N_("Point that the first pin is on."),
        "length": N_("From its first pin to its second."),
    },
    "ChainGuideSpec": {
        "through": N_("Fixed point beside which the guide runs; O is the shaft's centre."),
        "direction": N_("Direction of the guide from x toward y; the slider's position counts along it."),
        "offset": N_("Distance of the guide from that point, to the left of its direction."),
    },
    "SwivelGuideSpec": {
        "name": N_("Name of the guide, which is a link."),
        "start": N_("Point about which it rocks."),
        "offset": N_("Of its line from that point, to the left of its direction."),
    },
    "PinPartSpec": {
        "type": N_("Type of group."),
        "rod": N_("The rod, from the driving point to the joint."),
        "rocker": N_("The rocker, from its pivot to the joint."),
        "joint": N_("Name of the point where both meet."),
        "side": N_("Of the line from the rod's first pin to the rocker's, on which the joint lies."),
    },
    "SlidePartSpec": {
        "type": N_("Type of group."),
        "rod": N_("The rod, from the driving point to the slider."),
        "slider": N_("Name of the slider; its pin is the point NAME.pin."),
        "guide": N_("The fixed guide."),
        "side": N_("Whether the slider lies ahead of or behind the foot of the rod's first pin, along the guide."),
    },
    "SwivelPartSpec": {
        "type": N_("Type of group."),
        "pin": N_("Point that carries the slider."),
        "guide": N_("The guide in which it slides."),
        "slider": N_("Name of the slider, whose position counts along the guide."),
        "side": N_("Whether the slider lies ahead of or behind the pivot, along the guide."),
    },
    "YokePartSpec": {
        "type": N_("Type of group."),
        "pin": N_("Point that carries the block in the slot."),
        "slider": N_("Name of the slotted slider; where its slot meets the guide is the point NAME.pin."),
        "guide": N_("The fixed guide."),
        "slot_angle": N_("From the guide's direction to the slot."),
    },
    "TrammelPartSpec": {
        "type": N_("Type of group."),
        "link": N_("Link that carries the slot."),
        "slider": N_("Name of the slider; its pin is the point NAME.pin."),
        "guide": N_("The fixed guide."),
        "shift": N_("Of the slot from the link's line, to the left."),
    },
    "PointPartSpec": {
        "type": N_("Type of group."),
        "name": N_("Name of the point."),
        "link": N_("The link that carries it, or the slider in a fixed guide."),
        "along": N_("Distance from the link's first pin toward its second; from a slider's pin along its guide."),
        "across": N_("Distance from the line of pins, or from the guide, to its left."),
    },
    "TriadPartSpec": {
        "type": N_("Type of group."),
        "link": N_("Name of the link that the three legs hold."),
        "leg": N_("The three legs, each with its joint on the link."),
    },
    "TriadLegSpec": {
        "along": N_("Joint's distance along the link, from a point of it that is the same for all legs."),
        "across": N_("Joint's distance from the link's line through that point, to its left."),
        "joint": N_("Name of the joint, of a leg that is a rod."),
        "rod": N_("The rod, from a point above to the joint; for a circular slot, from the slot's centre."),
        "slider": N_("Name of the slider, of a leg that is a guide; its pin, NAME.pin, is the joint."),
        "guide": N_("The fixed guide."),
        "near": N_("Where about the joint lies when the crank lies along x: chooses the assembly mode."),
    },
    "EccentricSpec": {
        "eccentricity": N_("From shaft centre to the eccentric's centre."),
        "rod_length": N_("Of the eccentric rod, to the valve's pin."),
        "angle_of_advance": N_("How far the eccentric stands beyond the right angle to the crank; or angle_ahead."),
        "admission": N_("Past the valve's outer edges, with the eccentric 90° + δ ahead, or inner ones, −90° + δ."),
        "angle_ahead": N_("How far the eccentric stands ahead of the crank, instead of advance and admission."),
        "offset": N_("Of the valve's line from the shaft, positive toward +y."),
    },
    "StephensonSpec": {
        "notch": N_("Of the reverser: 1 full gear ahead, 0 mid gear, −1 full gear astern."),
        "eccentricity": N_("From shaft centre to the centre of either eccentric."),
        "angle_of_advance": N_("How far either eccentric stands beyond the right angle to the crank."),
        "admission": N_("Past the valve's outer edges or its inner ones."),
        "rods": N_("Open, if they do not cross while the eccentrics face the link, or crossed."),
        "eccentric_rod_length": N_("Of both eccentric rods, to their joints on the link."),
        "pin_spacing": N_("Between the joints of the eccentric rods on the link."),
        "pin_setback": N_("Of the line of these joints from the middle of the slot, toward the shaft."),
        "link_radius": N_("Of the slot, about a centre toward the shaft; unless given, it is straight."),
        "saddle_setback": N_("Of the lifting link's joint from the middle of the slot, toward the shaft."),
        "lifting_link_length": N_("From the arm of the reverse shaft to the middle of the link."),
        "lifting_arm_length": N_("Of the arm on the reverse shaft."),
        "lifting_arm_angle": N_("Direction of the arm at mid gear, from x toward y."),
        "lifting_arm_swing": N_("How far the arm turns from mid gear to full gear ahead."),
        "reverse_shaft_x": N_("Of the reverse shaft, from the main shaft along the valve's line."),
        "reverse_shaft_y": N_("Of the reverse shaft, from the main shaft toward +y."),
        "offset": N_("Of the valve's line from the shaft, positive toward +y."),
    },
    "WalschaertsSpec": {
        "crosshead": N_("The bank whose crosshead, on the same throw, moves the combination lever."),
        "notch": N_("Of the reverser: 1 full gear ahead, 0 mid gear, −1 full gear astern."),
        "admission": N_("Past the valve's inner edges or its outer ones."),
        "eccentricity": N_("From shaft centre to the return crank's pin."),
        "eccentric_advance": N_("How far the return crank stands ahead of the right angle to the main crank."),
        "eccentric_rod_length": N_("From the return crank's pin to its joint on the link."),
        "trunnion_x": N_("Of the link's trunnion, from the shaft along the valve's line."),
        "trunnion_y": N_("Of the link's trunnion, from the shaft toward +y."),
        "foot_distance": N_("From the trunnion, along the link, to the eccentric rod's joint."),
        "foot_setback": N_("Of that joint from the link, toward the shaft."),
        "full_gear_die": N_("From the trunnion to the block in full gear ahead, toward the foot."),
        "radius_rod_length": N_("From the block to the combination lever; the radius of the link's slot, too."),
        "lever_length": N_("Of the combination lever, from the radius rod's pin to the union link's."),
        "valve_pin_distance": N_("On the combination lever, from the radius rod's pin to the valve's."),
        "union_link_length": N_("From the crosshead's drop arm to the combination lever."),
        "drop_x": N_("Of the union link's pin on the crosshead, from the crosshead's pin along the cylinder."),
        "drop_y": N_("Of the union link's pin on the crosshead, from the crosshead's pin toward +y."),
        "offset": N_("Of the valve's line from the shaft, positive toward +y."),
    },
    "ArticulatedRodSpec": {
        "master": N_("The bank whose rod, on the same throw, carries the knuckle pin."),
        "knuckle_radius": N_("From crank pin to knuckle pin."),
        "rod_length": N_("From knuckle pin to the slave's piston pin."),
        "articulation_angle": N_(
            "From the master rod to the knuckle pin about the crank pin, in the sense of rotation."
        ),
        "offset": N_("Of the slave's line of stroke from the shaft, in its own cylinder's axes."),
    },
}


def described(spec: type[Spec], field: str) -> str:
    """Say what a key of the machine file is.

    Parameters
    ----------
    spec : type of Spec
    field : str

    Returns
    -------
    str
        What the field's own declaration says, or else the sentence of this module, also that of a base class.
    """
    own = spec.model_fields[field].description
    if own is not None:
        return _(own)
    homes = (_SENTENCES.get(base.__name__, {}) for base in spec.__mro__)
    return _(next(home[field] for home in homes if field in home))
