"""Paper: sheets in millimetres, sketches, shapes, labels and styles."""
