"""What drives a machine: motors and their sizing."""
