"""The texts' own examples, as the small tables that users write."""

from pathlib import Path
from typing import Literal


def example_table(of: Literal["drive", "throw"]) -> str:
    """Give the table of the text's own drive, or throw."""
    return Path(__file__).with_name(f"{of}_example.toml").read_text(encoding="utf-8")
