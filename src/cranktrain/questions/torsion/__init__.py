"""Torsion: the crankshaft's natural frequencies and modes, and the speeds that are critical for them."""
