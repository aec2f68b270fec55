#!/bin/bash
# Plays one map for MINUTES with random keys, on a display that nobody looks at, and saves, loads and changes the map's
# file all the while. play_soak.sh PROGRAM MINUTES [SEED]: a line of figures every sixth of the time; exit status 1
# where the game ended, did not save, or memory or open files grew after the first sixth.
set -u
program=$(realpath "$1") minutes=$2
RANDOM=${3:-1}
top=$(cd "$(dirname "$0")/../../.." && pwd)
for tool in Xvfb xdotool; do
    command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done

# What the program may take more than at the first figure: pieces of memory that the C library does not give back.
spare_kib=16384
restart_every=100 # cycles; a load plays all ticks since the start again
keys=(w w w a s d Left Right Up Down space e c r Tab plus minus F1 F2 F3 F4 F6 F7 F8 Page_Up Page_Down Home)

work=$(mktemp -d)
export HOME=$work/home XDG_CONFIG_HOME=$work/home/.config XDG_DATA_HOME=$work/home/.local/share
export XDG_CACHE_HOME=$work/home/.cache SDL_AUDIODRIVER=dummy SDL_VIDEODRIVER=x11
unset WAYLAND_DISPLAY
mkdir -p "$work/maps" "$HOME"
cp "$top/maps/lodge.toml" "$work/maps/"
ln -s "$top/maps/textures" "$top/maps/sounds" "$top/maps/prefabs" "$work/maps/"

mkfifo "$work/number"
Xvfb -displayfd 3 -screen 0 640x400x24 >/dev/null 2>&1 3<>"$work/number" &
xvfb=$!
read -r display <"$work/number"
export DISPLAY=:$display
"$program" play "$work/maps/lodge.toml" --size 320x200 --save "$work/game.save" 2>"$work/said" &
pid=$!
trap 'kill $pid $xvfb 2>/dev/null; rm -rf "$work"' EXIT
for _ in $(seq 300); do
    xdotool search --name '^Enfilade' >/dev/null 2>&1 && break
    sleep 0.1
done

is_alive() { kill -0 "$pid" 2>/dev/null; }
memory() { awk '/^VmRSS/ { print $2 }' "/proc/$pid/status"; }
files() { find "/proc/$pid/fd" -mindepth 1 | wc -l; }
press() { xdotool key --delay 25 "$@"; }

saves=0 loads=0 reloads=0 pressed=0 cycles=0 first_memory='' first_files='' inode=''
begin=$SECONDS
period=$((minutes * 10)) # a sixth of the time [s]
next=$period

show() {
    echo "$(((SECONDS - begin) / 60)) min: $(memory) KiB, $(files) open files; $pressed keys, $saves saves," \
        "$loads loads, $reloads reloads"
}

# The game that is saved is another file each time, as it is put in the place of the one before.
count_save() {
    local now
    now=$(stat -c %i-%Y "$work/game.save" 2>/dev/null)
    [ "$now" = "$inode" ] || saves=$((saves + 1))
    inode=$now
}

while is_alive && [ $((SECONDS - begin)) -lt $((minutes * 60)) ]; do
    random=()
    for _ in 1 2 3 4; do random+=("${keys[RANDOM % ${#keys[@]}]}"); done
    press F5 "${random[0]}" F9 "${random[@]:1}"
    cycles=$((cycles + 1)) loads=$((loads + 1)) pressed=$((pressed + 6))
    count_save
    if [ $((cycles % 10)) -eq 0 ]; then
        touch "$work/maps/lodge.toml"
        reloads=$((reloads + 1))
        sleep 0.6 # it looks twice a second
        press F9  # what was loaded again cannot be saved before that
    fi
    [ $((cycles % restart_every)) -eq 0 ] && press Escape Down Down Down Return
    if [ $((SECONDS - begin)) -ge $next ] && [ $next -lt $((minutes * 60)) ]; then
        show
        next=$((next + period))
        : "${first_memory:=$(memory)}" "${first_files:=$(files)}"
    fi
done

is_alive || { wait "$pid"; echo "the game ended with $?: $(cat "$work/said")"; exit 1; }
show
status=0
[ "$saves" -gt $((cycles / 2)) ] || { echo "only $saves of $cycles games were saved"; status=1; }
[ "$(memory)" -le $((first_memory + spare_kib)) ] || { echo "memory grew from $first_memory KiB"; status=1; }
[ "$(files)" -le "$first_files" ] || { echo "open files grew from $first_files"; status=1; }
exit $status
