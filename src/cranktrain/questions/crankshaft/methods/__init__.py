"""Methods for the loads of main bearings, the most exact first; each is a file."""

from cranktrain.questions.crankshaft.methods.split import SPLIT

BEARING_METHODS = (SPLIT,)
