"""Loads in the words of engine dynamics: forces of a piston, of its rod on the crank pin; rods replaced by masses."""
