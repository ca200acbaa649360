#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the packages of scripts/package.sh in a new Debian system below /tmp, as root, evaluates a method in Python and
# runs the first campaign of the README there, removes the packages, and fails if they left anything:
#   scripts/check_packages.sh [SUITE [FOLDER]]
# SUITE is a code name, default bookworm (Debian 12). FOLDER, default build/release, holds the packages of that release;
# `scripts/check_platform.sh --packages` makes them for another one. Needs the packages debootstrap or mmdebstrap and
# util-linux, and a mirror. Not part of scripts/test.sh, as it downloads a system.
set -euo pipefail
sources=$(dirname "$(dirname "$(realpath "$0")")")
source "$sources/scripts/chroot.sh"
[ "${1:-}" != --help ] || { usage && exit 0; }
suite=${1:-bookworm} folder=${2:-$sources/build/release}
expect_suite "$suite"
for name in slalom python3-slalom slalom-doc; do
  compgen -G "$folder/${name}_*.deb" >/dev/null || refuse "$folder: no ${name}_*.deb; expected the packages of scripts/package.sh"
done
with_private_mounts "$suite" "$folder"

new_system "$suite"
files() { (cd "$root" && find . -path ./proc -prune -o -path ./tmp -prune -o -path ./packages -prune -o -print | sort); }

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
write_python_campaign "$root/tmp/work"
inside sh -c 'cd /tmp/work && slalom-evaluate python.ini -o python -j 2 --quiet && test -s python/report/index.html &&
  slalom-analyze summary python/runs.results'
echo "== a report about a method in ten lines of Python in $(since $start)"

readme_campaign "$sources" >"$root/tmp/work/my.ini"
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
