"""From the table of a machine file to the diagram of one chamber: read, put in order, placed, pegged, smoothed."""

from dataclasses import replace

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.gas.indicator.brix import brix_angle
from cranktrain.gas.indicator.cycle import Samples, one_cycle
from cranktrain.gas.indicator.diagram import CURVES, Diagram, diagram_through, pressure_at, smoothed
from cranktrain.gas.indicator.findings import curve_findings
from cranktrain.gas.indicator.flags import compression_flags, lost_jump_flags, noise_flags, rounded_jump_flags
from cranktrain.gas.indicator.pegging import polytropic_offset
from cranktrain.gas.indicator.placing import placed
from cranktrain.gas.indicator.spec import IndicatorSpec, PegSpec, trace_of
from cranktrain.gas.indicator.unrolling import OutwardAngle, dead_centres_of, unrolled
from cranktrain.gas.kind import Chamber
from cranktrain.gas.state import ChamberState
from cranktrain.language import _
from cranktrain.motion import Array, single
from cranktrain.numerics import around_zero
from cranktrain.quantities import shown


def indicator_diagram(spec: IndicatorSpec, chamber: Chamber) -> Diagram:
    """Make the diagram of a chamber out of the file.

    Parameters
    ----------
    spec : IndicatorSpec
    chamber : Chamber

    Returns
    -------
    Diagram
        Counted from the chamber's nominal firing: the file's dead centre is the chamber's true one.

    Raises
    ------
    InputError
        If the file is no diagram of such a machine.
    """
    trace = trace_of(spec)
    if trace.axis == "angle":
        _refuse_strokes(spec)
        samples = one_cycle(trace, chamber.cycle)
        samples = samples._replace(flags=(*samples.flags, *lost_jump_flags(samples, chamber.cycle)))
        firing = None if spec.firing_angle is None else spec.firing_angle.si
        samples = placed(samples, chamber.cycle, firing, spec.sense)
        samples = _from_nominal(samples, chamber)
    else:
        _refuse_angles(spec, trace.axis)
        samples = unrolled(trace, chamber, CURVES[spec.interpolation], _outward(spec, chamber))
    samples = samples._replace(findings=(*trace.findings, *samples.findings), flags=(*trace.flags, *samples.flags))
    highest = int(np.argmin(np.abs(samples.pressures - np.max(trace.pressures))))
    if spec.peg is not None:
        diagram = diagram_through(samples, chamber.cycle, spec.interpolation)
        samples = _pegged(samples, diagram, spec.peg, chamber)
    flags = (*samples.flags, *compression_flags(samples, chamber))
    if spec.smoothing is None:
        flags = (*flags, *noise_flags(samples))
    if spec.interpolation == "spline" or spec.smoothing is not None:
        flags = (*flags, *rounded_jump_flags(samples))
    diagram = diagram_through(samples._replace(flags=flags), chamber.cycle, spec.interpolation)
    if spec.smoothing is not None:
        diagram = smoothed(diagram, spec.smoothing.si, spec.interpolation)
    told = curve_findings(diagram.curve, samples, highest, dead_centres_of(chamber.volume).top)
    return replace(diagram, findings=(*diagram.findings, *told))


def indicator_pressure(state: ChamberState, diagram: Diagram) -> Array:
    """Pressure of a chamber by its indicator diagram.

    Parameters
    ----------
    state : ChamberState, shape (..., n)
    diagram : Diagram

    Returns
    -------
    Array, shape (..., n)
        Absolute pressure. [Pa]
    """
    return pressure_at(diagram, state.angle_from_firing)


def _refuse_angles(spec: IndicatorSpec, axis: str) -> None:
    """Refuse what only a file over the crank angle can have: strokes over a volume are told by their pressures."""
    allowed = _("is for a file over the crank angle; this one is over {axis}").format(axis=axis)
    given = {"firing_angle": spec.firing_angle is not None, "sense": spec.sense != "forward"}
    wrong = [Problem(name, None, allowed) for name, is_given in given.items() if is_given]
    if wrong:
        raise InputError(wrong)


def _refuse_strokes(spec: IndicatorSpec) -> None:
    """Refuse a way of unrolling for a file that is over the crank angle as it is."""
    if spec.unrolling != "exact":
        raise InputError([Problem("unrolling", spec.unrolling, _("is for a file over volume or displacement"))])


def _from_nominal(samples: Samples, chamber: Chamber) -> Samples:
    """Count from nominal firing, where the file counts from the dead centre: an offset sets them apart."""
    top = dead_centres_of(chamber.volume).top
    if top == 0.0:
        return samples
    angles = np.mod(samples.angles + top, chamber.cycle)
    order = np.argsort(angles, kind="stable")
    told = _(
        "The file's dead centre is put on the machine's true one, {angle} from where the crank lies along the cylinder."
    )
    told = told.format(angle=f"{shown(top, 'deg'):.3f}°")
    return samples._replace(
        angles=angles[order], pressures=samples.pressures[order], findings=(*samples.findings, told)
    )


def _outward(spec: IndicatorSpec, chamber: Chamber) -> OutwardAngle | None:
    """Choose how displacements become crank angles."""
    if spec.unrolling == "exact":
        return None
    if chamber.ratio is None:
        allowed = _("is for a central slider-crank only; its construction knows no other mechanism")
        raise InputError([Problem("unrolling", spec.unrolling, allowed)])
    ratio = single(chamber.ratio)
    return lambda travelled: brix_angle(2.0 * travelled, single(1.0), ratio)


def _pegged(samples: Samples, diagram: Diagram, peg: PegSpec, chamber: Chamber) -> Samples:
    """Move all pressures to the level that is known."""
    if peg.pressure is not None:
        offset = peg.pressure.si - float(pressure_at(diagram, np.array(peg.angle.si)))
    else:
        assert peg.exponent is not None  # the spec asks for one of the two
        from_firing = around_zero(samples.angles, chamber.cycle)
        chosen = (peg.start.si <= from_firing) & (from_firing <= peg.end.si)
        if np.count_nonzero(chosen) < 2:
            allowed = _("must be a piece of the compression with two samples at least")
            raise InputError([Problem("peg.start", peg.start.text, allowed)])
        volumes = chamber.volume(from_firing[chosen])
        offset = polytropic_offset(samples.pressures[chosen], volumes, peg.exponent.si)
    told = _("All pressures are moved by {offset} kPa, to the level that is known.")
    return samples._replace(
        pressures=samples.pressures + offset,
        findings=(*samples.findings, told.format(offset=f"{shown(offset, 'kPa'):+.4g}")),
    )
