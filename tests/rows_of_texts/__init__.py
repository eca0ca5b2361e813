"""Checks of the rows of the texts' pages, each of the machine that its command names, against `run` of it."""
