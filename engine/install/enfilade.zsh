#compdef enfilade wadconv
# Completion for zsh: the commands and options that --help names at the moment; else files.

local program=$words[1] command=
[[ ${program:t} == enfilade ]] && command=$words[2]
if [[ ${program:t} == enfilade && CURRENT -eq 2 && $words[CURRENT] != -* ]]; then
    compadd -- $("$program" --help 2>/dev/null | sed -n '/^Commands:/,/^$/ s/^  \([a-z]*\) .*/\1/p')
elif [[ $words[CURRENT] == -* ]]; then
    compadd -- $("$program" ${command:+$command} --help 2>/dev/null | sed -n 's/^  \(-h,\)\{0,1\}\(--[a-z-]*\).*/\2/p')
else
    _files
fi
