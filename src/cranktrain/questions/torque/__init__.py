"""Torque: on the shafts, along them and through the gears between them; its orders, and the stars of their phases."""

from cranktrain.language import N_
from cranktrain.layout.question import Question, Stage
from cranktrain.questions.forces.piston_forces import have_direct_rods
from cranktrain.questions.torque import orders, rod_orders, rows, sources, torques, work_check

QUESTION = Question(
    "torque",
    stages=(
        Stage(sources.torque_sources),
        Stage(torques.shaft_torques),
        Stage(torques.gear_torques, applies=torques.are_geared),
        Stage(work_check.work_balance),
        Stage(work_check.load_balance),
        Stage(orders.torque_orders),
        Stage(orders.phase_star_sums),
        Stage(torques.journal_torques),
        Stage(rod_orders.rod_orders, applies=have_direct_rods),
    ),
    headline=("mean_torque", "largest_torque", "smallest_torque"),
    title=N_("Torque"),
    rows=(
        rows.torque_rows,
        rows.star_rows,
        rows.gear_rows,
    ),
)
