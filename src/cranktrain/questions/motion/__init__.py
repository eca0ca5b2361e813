"""Motion: how pistons, rods, rockers and points on links move."""
