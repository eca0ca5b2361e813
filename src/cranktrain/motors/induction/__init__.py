"""What induction motors have in common: Kloss's formula, currents, the field's speed, starters; no motor itself."""
