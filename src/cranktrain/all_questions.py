"""Every question that can be asked of a machine, in the order in which people ask them."""

from cranktrain.layout.question import Question
from cranktrain.questions import (
    balance,
    crankshaft,
    cylinders,
    drive,
    evenness,
    forces,
    gas,
    loads,
    motion,
    press,
    pumping,
    reduction,
    servo,
    sizing,
    start,
    torque,
    torsion,
    wear,
)

QUESTIONS: tuple[Question, ...] = (
    motion.QUESTION,
    cylinders.QUESTION,
    gas.QUESTION,
    forces.QUESTION,
    loads.QUESTION,
    torque.QUESTION,
    pumping.QUESTION,
    balance.QUESTION,
    evenness.QUESTION,
    wear.QUESTION,
    crankshaft.QUESTION,
    torsion.QUESTION,
    reduction.QUESTION,
    drive.QUESTION,
    servo.QUESTION,
    sizing.QUESTION,
    start.QUESTION,
    press.QUESTION,
)
