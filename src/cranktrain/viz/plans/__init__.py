"""Sheets of plans, constructions and polygons."""
