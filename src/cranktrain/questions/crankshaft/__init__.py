"""What the bearings of a crankshaft carry."""
