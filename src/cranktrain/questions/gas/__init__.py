"""Gas: its pressure in the chambers, its work and the powers."""
