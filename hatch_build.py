"""What is made when the package is built: lists for which the program would else import all of itself, and a template.

The lists are of the names that shells complete, and of the questions that most machine files do not ask; the template
is of all messages, for translators.
"""

import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class MadeWhenBuilt(BuildHookInterface):
    """Makes them in the tree, from which the archive of the sources and the package take them."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Make the lists always; the template only for the archive, as the program does not read it."""
        sys.path.insert(0, str(Path(self.root, "src")))
        from cranktrain.analysis.unasked import write_list
        from cranktrain.cli.completing.making import write_names

        write_list(Path(self.root, "src/cranktrain/analysis/unasked.json"))
        write_names(Path(self.root, "src/cranktrain/cli/completing/names.json"))
        if self.target_name == "sdist":
            self._write_template()

    def _write_template(self) -> None:
        from babel.messages.frontend import CommandLineInterface
        from babel.messages.pofile import read_po, write_po

        from cranktrain.cli.other_messages import other_messages

        source, of = Path(self.root, "src/cranktrain"), self.metadata
        (author,) = of.core.authors
        options = ["-k", "N_", "--no-location", "--sort-output", "--copyright-holder", author["name"]]
        options += ["--project", of.name, "--version", of.version]
        template = source / "locale/cranktrain.pot"
        (source / "locale").mkdir(exist_ok=True)
        CommandLineInterface().run(["pybabel", "-q", "extract", *options, "-o", str(template), str(source)])
        with template.open("rb") as file:
            messages = read_po(file)
        for message in other_messages():
            messages.add(message)
        with template.open("wb") as file:
            write_po(file, messages, sort_output=True)
