#!/bin/sh
# parts.sh parallel|slurm ENFILADE SCRIPT: films, records and checks the flythrough in 2, 3 and 8 parts, as
# engine/app/README.md tells it, and compares every byte with the same done in one piece. slurm needs root: it starts
# a cluster of this one machine.
set -eu

runner=$1
enfilade=$(realpath "$2")
script=$(realpath "$3")
top=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
name=$(basename "$script" .toml)
ENFILADE_MAP_CACHE=off
export ENFILADE_MAP_CACHE

if [ "$runner" = slurm ]; then
    # shellcheck source=tests/parts/one_machine_cluster.sh
    . "$top/one_machine_cluster.sh"
    start_cluster "$scratch"
    trap 'stop_cluster; rm -rf "$scratch"' EXIT
fi

# COUNT OPTIONS…: the flythrough in so many parts.
fly_in_parts() {
    count=$1
    shift
    case $runner in
        parallel) seq "$count" | parallel --will-cite "$enfilade" fly "$name.toml" --part "{}/$count" --threads 1 --quiet "$@" ;;
        slurm) sbatch --quiet --wait --array="1-$count" --output=job-%a.txt --wrap "$enfilade fly $name.toml \
--part \$SLURM_ARRAY_TASK_ID/\$SLURM_ARRAY_TASK_COUNT --threads 1 --quiet $*" ;;
    esac
}

# A folder with the script and what it needs, so that its parts lie in nobody's way.
mkdir "$scratch/work"
cp -r "$(dirname "$script")/.." "$scratch/work/maps"
cd "$scratch/work/maps/$(basename "$(dirname "$script")")"
"$enfilade" fly "$name.toml" --out whole --quiet
"$enfilade" fly "$name.toml" --record --quiet
mkdir recorded
cp "$name.hashes" "$name.sheet.png" recorded

for count in 2 3 8; do
    fly_in_parts "$count" --out "frames-$count"
    diff -r whole "frames-$count"
    rm "$name.hashes" "$name.sheet.png"
    fly_in_parts "$count" --record
    "$enfilade" fly "$name.toml" --merge
    for file in "$name.hashes" "$name.sheet.png"; do cmp "$file" "recorded/$file"; done
    fly_in_parts "$count" --check
    echo "$runner: $count parts, $(find whole -name '*.png' | wc -l) frames, the same bytes"
done

# A part that differs is found.
sed -i "s/^0 ................/0 0000000000000000/" "$name.hashes"
if fly_in_parts 2 --check 2>differs; then echo "the frame that differs was not found" && exit 1; fi
