"""The sources' own formulas, computed beside the exact ones: each with its equation, its range and its error."""
