"""Which motor is enough: torque over time, duty, starts, and flywheels that help."""
