"""A crank that follows a wanted motion: how it moves, and what its motor must give."""
