"""The table [drive], which several questions read: stages, what turns with them, motor, clutch, brake, duty, start."""
