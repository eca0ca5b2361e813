"""All that acts on the machine's crankshafts: rods, cranks, weights, pulls and gears."""
