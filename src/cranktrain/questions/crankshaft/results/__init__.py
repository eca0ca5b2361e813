"""What is said of the crankshafts: results with the stages that give them."""
