"""Evenness: the speed over the cycle, and the flywheel for it."""
