"""The scripts by which shells ask for completions."""

from collections.abc import Mapping

from cranktrain.errors import InputError

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
