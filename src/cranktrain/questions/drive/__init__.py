"""What drives a machine: motors, their sizing, and how it starts, runs and stops."""
