"""A press whose flywheel turns on while a clutch takes the crank along and a brake stops it: single strokes."""
