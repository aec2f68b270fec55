#!/bin/bash
# Plays as a person would: `enfilade` alone on a display that nobody looks at, with real keys, a real mouse and a gamepad
# that nobody holds. desktop_test.sh PROGRAM VIRTUAL_GAMEPAD [FOLDER]: a screenshot of each step is left in FOLDER.
# Exit status 77: what is needed is not installed.
set -u
program=$1 gamepad=$2
for tool in Xvfb xdotool import; do
    command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done

work=$(mktemp -d)
shots=${3:-}
mkdir -p "$work/home/Pictures" ${shots:+"$shots"}
export HOME=$work/home XDG_CONFIG_HOME=$work/home/.config XDG_DATA_HOME=$work/home/.local/share
export XDG_CACHE_HOME=$work/home/.cache SDL_AUDIODRIVER=dummy SDL_VIDEODRIVER=x11
unset WAYLAND_DISPLAY XDG_PICTURES_DIR
settings=$XDG_CONFIG_HOME/enfilade/settings.toml
failures=0 steps=0 before='' pid=''

mkfifo "$work/gamepad"
exec 8<>"$work/gamepad"
exec 9<>"$work/number" 2>/dev/null || exec 9>"$work/number"
Xvfb -displayfd 9 -screen 0 1280x800x24 >/dev/null 2>&1 &
xvfb=$!
trap 'kill $xvfb $pid 2>/dev/null; rm -rf "$work"' EXIT
for _ in $(seq 50); do
    [ -s "$work/number" ] && break
    sleep 0.1
done
display=:$(cat "$work/number")
export DISPLAY=$display

fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}

start() {
    LD_PRELOAD=$gamepad ENFILADE_TEST_GAMEPAD=$work/gamepad "$program" "$@" 2>"$work/said" &
    pid=$!
    for _ in $(seq 100); do
        xdotool search --name '^Enfilade' >/dev/null 2>&1 && break
        sleep 0.1
    done
    sleep 1.5
}

# The picture on the screen, which must not be the one of the step before. Not compressed but where somebody wants it.
step() {
    steps=$((steps + 1))
    local shot
    shot=$work/$1.ppm
    import -window root "$shot"
    [ -z "$before" ] || ! cmp -s "$before" "$shot" || fail "$1 shows what was there before"
    [ -z "$shots" ] || convert "$shot" "$shots/$(printf '%02d' $steps)-$1.png"
    before=$shot
}

keys() {
    for key in "$@"; do
        xdotool key --delay 40 "$key"
        sleep 0.12
    done
    sleep 0.4
}

pad() {
    echo "$*" >&8
    sleep 0.15
}

tap() {
    pad button "$1" 1
    pad button "$1" 0
    sleep 0.3
}

# How many hundredths of a core it takes for so many seconds.
processor() {
    local from to
    from=$(awk '{ print $14 + $15 }' "/proc/$pid/stat")
    sleep "$1"
    to=$(awk '{ print $14 + $15 }' "/proc/$pid/stat")
    echo $(((to - from) * 100 / ($1 * $(getconf CLK_TCK))))
}

at_most() {
    local found
    found=$(processor 4)
    echo "$2: $found % of a core"
    [ "$found" -le "$1" ] || fail "$2: $found % of a core, expected at most $1"
}

expect_setting() { grep -qx "$1" "$settings" || fail "expected '$1' in the settings, found '$(grep "^${1%% *} " "$settings")'"; }

ended() {
    for _ in $(seq 40); do
        kill -0 "$pid" 2>/dev/null || break
        sleep 0.1
    done
    kill -KILL "$pid" 2>/dev/null && fail 'the program does not end'
    wait "$pid"
    local status=$?
    [ $status -eq 0 ] || fail "the program ended with $status: $(cat "$work/said")"
    pid=''
    before=''
}

# By keys and mouse, for the first time.
start
step title
keys Down Down Down Return
step help
keys Escape Up Up Return
step options
keys Down Down Down Down Down Down Down Down Down Right
step wider-view
keys Escape Down Return Down Down Down Down Down Down Down Down Down Down Down Down Return
step waits-for-a-key
keys q
step bound
keys Escape Up Up Return
sleep 4
step maps
xdotool mousemove 630 180 mousemove 640 200 click 1
sleep 3
step playing
xdotool keydown w
sleep 1
xdotool keyup w
step walked
xdotool mousemove_relative 300 0
sleep 0.3
step looked
keys Tab
step automap
keys Right Up
step automap-moved
keys Home Tab F4
step from-outside
keys F4 F4 F1
step keys
keys F1 F12
step screenshot
[ -f "$HOME/Pictures/enfilade-0001.png" ] || fail 'there is no screenshot in the folder for pictures'
xdotool keydown Right
sleep 0.5
turning=$(processor 4)
xdotool keyup Right
sleep 4
# Of what a machine needs for sixty pictures a second, and not of a core, which may be slow or shared. The candles of
# this room flicker eight times a second; where nothing changes, nothing is drawn.
echo "turning: $turning % of a core"
at_most $((turning / 2)) 'standing still'
keys Escape
step menu
sleep 1
at_most 2 'paused'
keys Down Return
step saved
xdotool windowfocus 1
sleep 1
step without-focus
xdotool windowfocus "$(xdotool search --name '^Enfilade' | head -1)"
sleep 0.5
xdotool windowunmap "$(xdotool search --name '^Enfilade' | head -1)"
sleep 1
at_most 2 'hidden'
xdotool windowmap "$(xdotool search --name '^Enfilade' | head -1)"
sleep 1
before=''
step back-again
xdotool search --name '^Enfilade - ' >/dev/null || fail 'the window does not name the map'
keys Up Return
ended
expect_setting 'fov = 95'
expect_setting 'use = \["Q", "E"\]'

# Again, by gamepad: it goes on where it was left, as it was set.
start
step title-with-continue
tap 0
sleep 2
step went-on
pad axis 1 -32768
sleep 1
pad axis 1 0
step walked-by-stick
pad axis 2 20000
sleep 0.5
pad axis 2 0
step turned-by-stick
tap 4
step automap-by-gamepad
tap 4
tap 6
step menu-by-gamepad
tap 11
tap 0
ended
expect_setting 'fov = 95'

# By the other renderer, through OpenGL on the window, where it is there.
ENFILADE_GPU=on start play --renderer stencil --no-vsync
sleep 2
step stencil-on-the-window
keys F2
sleep 1
step column-again
kill -TERM "$pid"
ended

echo "$steps steps, $failures failures"
[ $failures -eq 0 ]
