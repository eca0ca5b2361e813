"""The cycle of a design, compiled for a machine's structure: facts of many designs in microseconds each."""
