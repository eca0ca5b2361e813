"""Dimensions found from wants."""
