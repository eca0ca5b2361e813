"""Forces: in every joint, on every piston, rod, pin and guide."""
