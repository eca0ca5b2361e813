"""Engines and other machines: shafts, banks, pistons, chambers, firing; one module for each stage."""
