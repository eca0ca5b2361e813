"""What runs in time: the equation of motion of a reduced machine, its steps, events and ends; arrays alone."""
