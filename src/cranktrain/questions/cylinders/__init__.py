"""Cylinders: travel, volumes, ports, firing."""
