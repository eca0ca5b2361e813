"""Studies of a machine beside its results: better dimensions from wants, and plans in the hand of the textbooks."""
