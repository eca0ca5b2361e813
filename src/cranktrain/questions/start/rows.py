"""What a start says in the answer: why it ended, what the motor gave, where the energy went, how close it is."""

from collections.abc import Iterator

from cranktrain.language import N_, _
from cranktrain.questions.start.facts import StartFacts, StrokeFacts, StrokeStops
from cranktrain.questions.start.record import StartRun
from cranktrain.saying.rows import AnswerLine, Telling, worded


def start_rows(
    of: Telling, run: StartRun, facts: StartFacts, stroke: StrokeFacts | None, stops: StrokeStops | None
) -> Iterator[AnswerLine]:
    """Rows of a run, in the order in which people ask."""
    yield of.line(_("it ends after"), N_("{start_duration}: {reason}"), facts, reason=run.reason)
    yield worded(
        _("turns of the crank"),
        _(
            "{turns}, reversals: {n}; at the end it turns at {speed}",
            turns=f"{float(facts.crank_turns[0]):.4g}".replace("-", "−"),
            n=f"{facts.crank_reversals[0]:.0f}",
            speed=of.amount(facts, "final_crank_speed"),
        ),
        quantity="crank_turns",
    )
    yield of.line(
        _("torque of the motor"),
        N_("{range}; effective {effective_motor_torque}"),
        facts,
        range=of.extent(facts, "smallest_motor_torque", "largest_motor_torque"),
    )
    yield worded(_("power of the motor"), of.extent(facts, "smallest_motor_power", "largest_motor_power"))
    words = (
        N_(
            "motor gives {final_motor_work}, loads take {final_load_work}, gearing, clutch and brake lose"
            " {final_lost_work}; {final_kinetic_energy} in motion at the end, {first_kinetic_energy} at the beginning"
        )
        if facts.first_kinetic_energy[0] > 0
        else N_(
            "motor gives {final_motor_work}, loads take {final_load_work}, gearing, clutch and brake lose"
            " {final_lost_work}; {final_kinetic_energy} in motion at the end"
        )
    )
    yield of.line(_("energy"), words, facts)
    if stroke is not None and stops is not None:
        yield from _stroke_rows(of, stroke, stops)
    if facts.final_motor_heat[0] > 0:
        yield worded(_("heat in the rotor"), of.amount(facts, "final_motor_heat"))
    yield from (worded(_("mind"), note) for note in run.notes)
    yield worded(
        _("computed"),
        _(
            "by {method} in {n} steps at {tolerance}; energy left over: {residual} of what was given",
            method=run.method,
            n=str(run.n_steps),
            tolerance=f"{run.tolerance:.0e}",
            residual=f"{facts.energy_left_over[0]:.1e}",
        ),
        quantity="energy_left_over",
    )


def _stroke_rows(of: Telling, stroke: StrokeFacts, stops: StrokeStops) -> Iterator[AnswerLine]:
    """What clutch and brake did, and the longest stop that a command on the way could lead to."""
    yield of.line(_("clutch"), N_("slips for {slip_time}, takes {heat_of_clutch}"), stroke)
    stopping = of.line(_("brake"), N_("stops in {angle_of_braking}, {time_of_braking}, takes {heat_of_brake}"), stroke)
    yield stopping if stopping.says else worded(_("brake"), _("is not commanded"))
    stop = of.line(
        _("longest stop"),
        N_(
            "{longest_stop_time}, commanded at {longest_stop_time_command}; {longest_stop_angle}, commanded at"
            " {longest_stop_angle_command} from the start"
        ),
        stops,
    )
    yield from [stop] if stop.says else []
