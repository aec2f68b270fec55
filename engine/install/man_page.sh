#!/bin/sh
# man_page.sh PAGE PROGRAM [COMMAND]: writes the manual page of a command, which help2man makes of what --help says.
set -eu

page=$(realpath -m "$1")
program=$(basename "$2")
command=${3:-}
name=$program${command:+-$command}
cd "$(dirname "$2")"
summary=$("./$program" ${command:+"$command"} --help | sed -n '1s/\.$//; 1p')
help2man --no-info --name "$summary" --version-string "$("./$program" --version)" --output "$page" \
    "./$program${command:+ $command}"
# help2man knows no programs with subcommands and calls the page as the program.
sed -i -e "s/^$program \\\\-/$name \\\\-/" \
    -e "s/^\.TH [^ ]*/.TH $(echo "$name" | tr '[:lower:]' '[:upper:]')/" "$page"
