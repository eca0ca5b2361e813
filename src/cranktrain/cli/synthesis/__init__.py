"""`synthesise`: a command for each problem."""
