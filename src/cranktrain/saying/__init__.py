"""What is said to people, as data: quantities by name, rows, checks and flags, numbers and names in sentences."""
