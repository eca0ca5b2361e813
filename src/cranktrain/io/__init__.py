"""Machine files in, results out: the text with its positions, and files written whole or not at all."""
