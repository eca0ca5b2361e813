"""Plans in the hand of the textbooks, as data."""
