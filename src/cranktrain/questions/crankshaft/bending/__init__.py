"""How a shaft bends and twists between its bearings under any loads, arrays alone."""
