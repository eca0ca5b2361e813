"""What a crankshaft is made of, arrays alone: pieces joined by webs, their sections, what lies between throws."""
