"""A throw of a machine, drawn to scale."""
