"""`python -m cranktrain`."""

import sys

from cranktrain.cli import main

if __name__ == "__main__":
    sys.exit(main())
