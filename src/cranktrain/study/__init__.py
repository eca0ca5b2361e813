"""What is computed beside one answer over the cycle: a start over time."""
