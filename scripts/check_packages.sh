#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the packages of scripts/package.sh in a new Debian system below /tmp, as root, evaluates a method in Python and
# runs the first campaign of the README there, removes the packages, and fails if they left anything:
#   scripts/check_packages.sh [SUITE [FOLDER]]
# SUITE is a code name, default bookworm (Debian 12). FOLDER, default build/release, holds the packages of that release;
# `scripts/check_platform.sh --packages` makes them for another one. Needs the packages debootstrap or mmdebstrap and
# util-linux, and a mirror. Not part of scripts/test.sh, as it downloads a system.
set -euo pipefail
usage() { sed -n '3,/^set /{/^set /d; s/^# \{0,1\}//; p}' "$0"; }
refuse() {
  echo "check_packages.sh: $1" >&2
  exit 2
}
[ "${1:-}" != --help ] || { usage && exit 0; }
sources=$(dirname "$(dirname "$(realpath "$0")")")
suite=${1:-bookworm} folder=${2:-$sources/build/release}
[[ $suite =~ ^[a-z]+$ ]] || refuse "$suite: expected the code name of a release of Debian, for example trixie"
for name in slalom python3-slalom slalom-doc; do
  compgen -G "$folder/${name}_*.deb" >/dev/null || refuse "$folder: no ${name}_*.deb; expected the packages of scripts/package.sh"
done
[ "$(id -u)" -eq 0 ] || refuse "a chroot is made by root only; use sudo"
[ "${SLALOM_PRIVATE_MOUNTS:-}" ] || SLALOM_PRIVATE_MOUNTS=1 exec unshare --mount "$0" "$suite" "$folder"

root=$(mktemp -d /tmp/slalom-packages.XXXXXX)
trap 'umount "$root/proc" 2>/dev/null; rm -rf "$root"' EXIT
chmod 755 "$root"
echo "== a new system: $suite"
mirror=http://deb.debian.org/debian
if command -v mmdebstrap >/dev/null; then
  mmdebstrap --quiet --variant=apt "$suite" "$root" $mirror
else
  debootstrap --variant=minbase "$suite" "$root" $mirror >/dev/null
fi
mount -t proc proc "$root/proc"
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C DEBIAN_FRONTEND=noninteractive "$@"; }
files() { (cd "$root" && find . -path ./proc -prune -o -path ./tmp -prune -o -path ./packages -prune -o -print | sort); }
since() { echo "$((SECONDS - $1)) s"; }

mkdir "$root/packages" "$root/tmp/work"
cp "$folder"/{slalom,python3-slalom,slalom-doc}_*.deb "$root/packages"
start=$SECONDS
inside apt-get update -qq
# First the dependencies, so that what remains later is of these packages.
names=$(for package in "$root"/packages/*.deb; do dpkg-deb -f "$package" Depends; done |
  tr ',' '\n' | awk '{print $1}' | grep -v '^slalom' | sort -u)
inside apt-get install -qq --no-install-recommends $names >/dev/null
files >"$root/packages/before"
inside sh -c 'apt-get install -qq --no-install-recommends /packages/*.deb' | grep -v '^Selecting\|^(Reading\|^Preparing'
echo "== installed in $(since $start)"

start=$SECONDS
cat >"$root/tmp/work/my_method.py" <<'PYTHON'
import math
class MyMethod:
    def __init__(self, robot, options):
        self.robot = robot
    def reset(self, task): pass
    def step(self, observation):
        bearing = math.atan2(observation.goal_y, observation.goal_x)
        ahead = observation.ranges[len(observation.ranges) // 2] - self.robot.radius
        v = min(self.robot.max_v, ahead / 2) if abs(bearing) < 0.5 else 0.0
        return v, math.copysign(min(self.robot.max_w, 2 * abs(bearing)), bearing)
PYTHON
cat >"$root/tmp/work/python.ini" <<'CAMPAIGN'
[campaign]
methods = nd, mine
[scenarios]
generator = random
count = 100
[method.nd]
adapter = mrpt_holonomic
class = CHolonomicND
[method.mine]
adapter = python
module = my_method.py
class = MyMethod
CAMPAIGN
inside sh -c 'cd /tmp/work && slalom-evaluate python.ini -o python -j 2 --quiet && test -s python/report/index.html &&
  slalom-analyze summary python/runs.results'
echo "== a report about a method in ten lines of Python in $(since $start)"

sed -n '/^## Your first campaign/,/^## /p' "$sources/README.md" | sed -n '/^```ini/,/^```/p' | sed '1d;$d' >"$root/tmp/work/my.ini"
# The method "mine" is the reader's own; one of the package takes its place.
inside sh -c 'cd /tmp/work && slalom-evaluate my.ini -o out -j 2 --quiet --set method.mine.plugin=libslalom_follow_the_gap.so &&
  test -s out/report/index.html && slalom-analyze summary out/runs.results'
echo "== the first campaign of the README: done"
inside sh -c 'cd /tmp/work && python3 -c "
import slalom
scenarios = slalom.generate(\"random\", 5, seed=1)
results = slalom.evaluate({\"gap\": slalom.plugin(\"libslalom_follow_the_gap.so\")}, scenarios)
print(len(scenarios), \"scenarios,\", len(results[\"success\"]), \"runs\")"'
echo "== the Python package: done"

inside dpkg --purge python3-slalom slalom-doc slalom | grep -v '^(Reading'
files >"$root/packages/after"
left=$(comm -13 "$root/packages/before" "$root/packages/after" | grep -v '^\./var/lib/dpkg/\|^\./var/log/\|^\./var/cache/' || true)
[ -z "$left" ] || { echo "left behind:"; echo "$left"; exit 1; }
echo "== removed: nothing is left"
