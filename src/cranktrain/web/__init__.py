"""Pages: a machine with all its answers as data that a browser draws, and the page that draws it."""
