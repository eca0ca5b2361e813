"""Sphinx settings: MyST pages, equations numbered by chapter. Nothing is fetched while building."""

import tomllib
from pathlib import Path

_metadata = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8"))["project"]

project = _metadata["name"]
author = copyright = _metadata["authors"][0]["name"]
release = version = _metadata["version"]

extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["deflist", "dollarmath"]
myst_heading_anchors = 3
nitpicky = True
exclude_patterns = ["_build"]

# An equation's label is its number: the chapter of the theory, then the place in it. A test compares the two.
numfig = True
numfig_secnum_depth = 1
math_numfig = True
math_number_all = False
math_eqref_format = "({number})"

html_theme = "furo"
html_title = f"{project} {release}"
html_copy_source = False
html_show_sourcelink = False
