"""Sphinx settings: MyST pages and notebooks, equations numbered by chapter. Nothing is fetched."""

import os
import sys
import tomllib
from pathlib import Path

_here = Path(__file__).parent
_metadata = tomllib.loads((_here.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]
sys.path.insert(0, str(_here / "extensions"))

# What the pages type is the program of this Python, in English and as on paper: 80 columns without colour.
os.environ["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])
os.environ |= {"LANGUAGE": "en", "NO_COLOR": "1", "COLUMNS": "80"}

project = _metadata["name"]
author = copyright = _metadata["authors"][0]["name"]
release = version = _metadata["version"]

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "numpydoc",
    "lessons",
    "mathml",
    "navigation",
    "typed",
    "results",
    "fields",
    "public_names",
]
myst_enable_extensions = ["deflist", "dollarmath"]
myst_heading_anchors = 3
nitpicky = True
exclude_patterns = ["_build"]

nb_merge_streams = True

# An equation's label is its number: the chapter of the theory, then the place in it. A test compares the two.
numfig = True
numfig_secnum_depth = 1
math_numfig = True
math_number_all = False
math_eqref_format = "({number})"
html_math_renderer = "mathml"

autodoc_typehints = "none"
autodoc_preserve_defaults = True
autodoc_member_order = "bysource"
numpydoc_show_class_members = False

html_theme = "furo"
html_title = f"{project} {release}"
html_copy_source = False
html_show_sourcelink = False
html_static_path = ["static"]
html_css_files = ["pages.css"]
