"""`textbook`: the sources' own formulas and errors."""
