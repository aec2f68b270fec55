#!/bin/sh
# clean_system.sh BUILD [SUITE]: makes the Debian packages of what was built there, and tries them in a fresh Debian, where
# no source folder is: installs them, runs the programs as a user, builds the examples with g++ and clang, removes the
# packages and looks for traces. Needs root, debootstrap and Debian's archive; takes about 1 GB and some minutes.
set -eu

build=$(realpath "$1")
suite=${2:-bookworm}
[ "$(id -u)" -eq 0 ] || { echo "only root can make a system of its own" && exit 1; }
root=$(mktemp -d /var/tmp/clean-system-XXXXXX)
chmod 755 "$root"
packages=$(mktemp -d)

clean_up() {
    umount "$root/proc" 2>/dev/null || true
    rm -rf "$root" "$packages"
}
trap clean_up EXIT
trap 'exit 1' INT TERM

say() { printf '\n=== %s\n' "$*"; }

# A command in the new system, as root or as a user.
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }
as_user() { inside runuser -u tester -- env HOME=/home/tester ENFILADE_MAP_CACHE=off "$@"; }
install() { inside sh -c "apt-get install -y -qq --no-install-recommends $*" >/dev/null; }

# All files but those that apt and dpkg keep about their work.
files() { (cd "$root" && find . -xdev \( -path ./proc -o -path ./var/cache -o -path ./var/log -o -path ./var/lib/apt \
    -o -path ./var/lib/dpkg -o -path ./tmp -o -path ./home -o -path ./packages \) -prune -o -print | sort); }

say "packages"
(cd "$packages" && cpack --config "$build/CPackConfig.cmake" -G DEB -B "$packages" >/dev/null)
ls -l "$packages"/*.deb
for package in "$packages"/*.deb; do lintian --no-tag-display-limit --fail-on none "$package" 2>/dev/null || true; done

say "a fresh $suite"
debootstrap --variant=minbase "$suite" "$root" >/dev/null
mount -t proc proc "$root/proc"
echo 'Dpkg::Use-Pty "0";' >"$root/etc/apt/apt.conf.d/quiet"
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
inside useradd --create-home tester

say "what the packages need, and what remains of them when they are gone"
inside sh -c 'apt-get update -qq && apt-get install -y -qq --no-install-recommends /packages/*.deb' >/dev/null
inside apt-get purge -y -qq enfilade enfilade-dev >/dev/null
files >"$packages/before"
find "$root" -xdev -path "$root/packages" -prune -o \( -iname '*enfilade*' -o -iname '*wadconv*' \) -print |
    grep -v /var/cache/ && echo "something of the packages is left" && exit 1

say "the programs, without anything of the source"
install '/packages/enfilade_*.deb'
as_user sh -c 'cd && enfilade --version && wadconv --version && enfilade check /usr/share/enfilade/maps'
# No lamps: their light the reference works out by itself.
for renderer in column stencil reference; do
    as_user sh -c "cd && enfilade render /usr/share/enfilade/maps/tutorial.toml --size 320x200 --renderer $renderer \
        --out $renderer.png"
done
as_user sh -c 'cd && cmp column.png reference.png'
as_user sh -c 'cd && enfilade fly /usr/share/enfilade/maps/flythroughs/tutorial.toml --check'
as_user sh -c 'cd && SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy timeout --preserve-status -s INT 2 enfilade play'
wad=/usr/share/games/doom/freedoom2.wad
if [ -f "$wad" ]; then
    cp "$wad" "$root/home/tester/"
    as_user sh -c 'cd && wadconv freedoom2.wad --map MAP01 --out levels && enfilade check --quiet levels/map01.toml'
fi

say "the examples, with g++ and clang"
install '/packages/enfilade-dev_*.deb' cmake ninja-build g++ clang-19
for compiler in g++ clang++-19; do
    as_user sh -c "cd && cmake -S /usr/share/enfilade/examples -B $compiler -G Ninja -DCMAKE_CXX_COMPILER=$compiler \
        -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' >/dev/null && cmake --build $compiler && ctest --test-dir $compiler"
done
as_user sh -c "cd && g++ -std=c++20 /usr/share/enfilade/examples/frame.cpp \
    $(inside pkg-config --cflags --libs enfilade | tr '\n' ' ') -o f && ./f /usr/share/enfilade/maps/enfilade.toml frame.png"

say "gone without a trace"
inside apt-get purge -y -qq enfilade enfilade-dev cmake ninja-build g++ clang-19 >/dev/null
files >"$packages/after"
# The compilers' own dependencies stay, as apt has it; of ours nothing does.
if comm -13 "$packages/before" "$packages/after" | grep -iE 'enfilade|wadconv'; then exit 1; fi
find "$root" -xdev \( -path "$root/packages" -o -path "$root/home" \) -prune -o \
    \( -iname '*enfilade*' -o -iname '*wadconv*' \) -print | grep -v /var/cache/ && exit 1
say "all is well"
