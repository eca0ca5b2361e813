"""A wanted motion of what the crank drives, and the speed of the crank that makes it."""
