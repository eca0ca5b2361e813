"""At which speeds a crankshaft vibrates in torsion: its modes, and Campbell's diagram."""
