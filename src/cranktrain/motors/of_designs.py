"""The motor of a table, or of the tables of several designs together."""

from cranktrain.motors.declared import DeclaredMotor
from cranktrain.motors.spec import DrivingMotorSpec


def motor_of(spec: DrivingMotorSpec, n_designs: int = 1) -> DeclaredMotor:
    """Motor that a table declares.

    Parameters
    ----------
    spec : DrivingMotorSpec
        Of one design, or of several in columns.
    n_designs : int

    Returns
    -------
    DeclaredMotor
        Its numbers of as many designs.
    """
    return spec.declared().over_designs(n_designs)
