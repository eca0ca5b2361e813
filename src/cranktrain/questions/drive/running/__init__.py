"""Machines that start, run, stall and stop: the equation of motion of a crank with a motor, gearing and a load."""
