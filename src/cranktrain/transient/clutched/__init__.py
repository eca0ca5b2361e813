"""Two masses with a clutch between them, and a brake: phases, what ends them, strokes that repeat."""
