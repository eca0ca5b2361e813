"""Torque: on the shafts, along them and through the gears between them; its orders, and the stars of their phases."""

from cranktrain.layout.question import Question, Stage
from cranktrain.questions.forces.piston_forces import have_direct_rods
from cranktrain.questions.torque.orders import phase_star_sums, torque_orders
from cranktrain.questions.torque.rod_orders import rod_orders
from cranktrain.questions.torque.sources import torque_sources
from cranktrain.questions.torque.torques import are_geared, gear_torques, journal_torques, shaft_torques, torque_peaks
from cranktrain.questions.torque.work_check import work_balance

QUESTION = Question(
    "torque",
    stages=(
        Stage(torque_sources),
        Stage(torque_peaks),
        Stage(shaft_torques),
        Stage(gear_torques, applies=are_geared),
        Stage(work_balance),
        Stage(torque_orders),
        Stage(phase_star_sums),
        Stage(journal_torques),
        Stage(rod_orders, applies=have_direct_rods),
    ),
    headline=("mean_torque", "largest_torque", "smallest_torque"),
)
