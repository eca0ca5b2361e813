"""The commands `completion` and `schema` as they are typed: what shells and editors are given."""

from typing import Annotated

import typer

from cranktrain.cli.options import Force, Output
from cranktrain.cli.task import put_off
from cranktrain.language import N_


def add_tools(app: typer.Typer) -> None:
    """Add the commands to the others."""

    @app.command(
        "completion",
        help=N_(
            "Give the script by which a shell completes commands, examples, kinds, results and paths.\n\n"
            "\b\n"
            '  eval "$(cranktrain completion bash)"          in ~/.bashrc; zsh likewise in ~/.zshrc\n'
            "  cranktrain completion fish | source            in config.fish"
        ),
    )
    @put_off
    def _completion(shell: Annotated[str, typer.Argument(metavar="[bash|zsh|fish]", show_default=False)]) -> None:
        from cranktrain.cli.completing.shells import show_script

        show_script(shell)

    @app.command(
        "schema",
        help=N_(
            "Give the JSON schema of machine files, for editors that complete and check TOML.\n\n"
            "A file whose first line is `#:schema ./cranktrain.schema.json` is checked as it is typed.\n\n"
            "\b\n"
            "  cranktrain schema -o cranktrain.schema.json"
        ),
    )
    @put_off
    def _schema(output: Output = None, force: Force = False) -> None:
        from cranktrain.cli.new import write_schema

        write_schema(output, force=force)
