"""Dimensions found from requirements."""
