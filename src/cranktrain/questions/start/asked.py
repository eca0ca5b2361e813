"""What a start goes by: what is asked of it, and what of the file can move and stop the crank."""

from cranktrain.layout.drive.declared import DeclaredBrake, DeclaredClutch, DeclaredStroke
from cranktrain.layout.wish.declared import RockingMotions, WantedMotions
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.questions.start.parts import DeclaredStart
from cranktrain.record import record
from cranktrain.transient.runs import Progress


@record
class StartAsked:
    """What is asked of a start besides what the file says.

    Attributes
    ----------
    times : Array or None
        At which curves stand, rising; as the file has it unless given. [s]
    progress : callable or None
        Told the time, the crank angle and the speed that it has come to; with it a user may stop a run, and what was
        computed so far is kept. [s, rad, rad/s]
    """

    times: Array | None = None
    progress: Progress | None = None


@record
class MovingParts:
    """What moves and stops the crank, as far as the file has it, and what of the file a start may leave out."""

    start: DeclaredStart
    motor: DeclaredMotor | None
    brake: DeclaredBrake | None
    clutch: DeclaredClutch | None
    stroke: DeclaredStroke | None
    wanted: WantedMotions | None
    rocking: RockingMotions | None
