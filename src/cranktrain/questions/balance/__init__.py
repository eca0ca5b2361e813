"""Balance: what shakes the frame, and the weights that balance it."""
