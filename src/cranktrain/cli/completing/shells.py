"""The scripts by which shells ask for completions, and the answer to one."""

import os
from collections.abc import Mapping, Sequence
from contextlib import suppress

from cranktrain.errors import InputError

ASKED = "_CRANKTRAIN_COMPLETE"
"""Variable with which a shell asks: the place of the word that is typed, counted from the program's name."""

SCRIPTS: Mapping[str, str] = {
    "bash": """\
# In ~/.bashrc:  eval "$(cranktrain completion bash)"
_cranktrain() {
    local IFS=$'\\n'
    local word="${COMP_WORDS[COMP_CWORD]}"
    compopt +o nospace
    COMPREPLY=( $(_CRANKTRAIN_COMPLETE="$COMP_CWORD" "${COMP_WORDS[0]}" "${COMP_WORDS[@]:1}" 2>/dev/null) )
    [[ "${COMPREPLY[0]}" == *= ]] && compopt -o nospace
}
complete -o default -F _cranktrain cranktrain
""",
    "zsh": """\
# In ~/.zshrc, after compinit:  eval "$(cranktrain completion zsh)"
_cranktrain() {
    local -a found
    found=("${(@f)$(_CRANKTRAIN_COMPLETE=$((CURRENT - 1)) "${words[1]}" "${(@)words[2,-1]}" 2>/dev/null)}")
    if [[ -n "$found" ]]; then
        compadd -S '' -- ${(M)found:#*=}
        compadd -- ${found:#*=}
    else
        _files
    fi
}
compdef _cranktrain cranktrain
""",
    "fish": """\
# In ~/.config/fish/config.fish:  cranktrain completion fish | source
function __cranktrain
    set -l words (commandline -opc) (commandline -ct)
    env _CRANKTRAIN_COMPLETE=(math (count $words) - 1) $words[1] $words[2..-1] 2>/dev/null
end
complete -c cranktrain -a '(__cranktrain)'
""",
}


def show_script(shell: str) -> None:
    """Print the script for a shell."""
    if shell not in SCRIPTS:
        from cranktrain.quantities import unlisted  # only after a mistake

        raise InputError([unlisted("SHELL", shell, list(SCRIPTS))])
    print(SCRIPTS[shell], end="")


def show_candidates(arguments: Sequence[str]) -> None:
    """Print what may stand where the shell says, one in a line; nothing where that is unknown or goes wrong."""
    with suppress(ValueError):
        place = int(os.environ[ASKED])
        typed = [*arguments, ""][:place]
        if place > 0 and len(typed) == place:
            from cranktrain.cli.app import commands
            from cranktrain.cli.completing.candidates import candidates

            for word in candidates(typed, commands()):
                print(word)
