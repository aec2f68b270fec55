# Completion for bash: the commands and options that --help names at the moment; else files.

_enfilade() {
    local program=$1 current=$2 command="" words=""
    if [[ ${program##*/} == enfilade && ${COMP_WORDS[1]-} != -* ]]; then command=${COMP_WORDS[1]-}; fi
    if [[ $current == -* ]]; then
        words=$("$program" ${command:+"$command"} --help 2>/dev/null | sed -n 's/^  \(-h,\)\{0,1\}\(--[a-z-]*\).*/\2/p')
    elif [[ ${program##*/} == enfilade && $COMP_CWORD -eq 1 ]]; then
        words=$("$program" --help 2>/dev/null | sed -n '/^Commands:/,/^$/ s/^  \([a-z]*\) .*/\1/p')
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}

complete -o default -F _enfilade enfilade wadconv
