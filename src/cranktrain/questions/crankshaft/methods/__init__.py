"""Methods for the loads of main bearings, the most exact first, and that of bearings with clearance last."""

from cranktrain.questions.crankshaft.methods.clearance import CLEARANCE
from cranktrain.questions.crankshaft.methods.crank_frame import ELASTIC_FRAME, RIGID_FRAME
from cranktrain.questions.crankshaft.methods.split import SPLIT
from cranktrain.questions.crankshaft.methods.straight import FIVE_MOMENT, THREE_MOMENT

BEARING_METHODS = (ELASTIC_FRAME, RIGID_FRAME, FIVE_MOMENT, THREE_MOMENT, SPLIT, CLEARANCE)
