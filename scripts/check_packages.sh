#!/usr/bin/env bash
# Installs the packages of scripts/package.sh in a new Debian system below /tmp, as root, runs the first campaign of the
# README and the Python package there, removes the packages, and reports what they left: scripts/check_packages.sh
# [SUITE]. Needs the packages debootstrap or mmdebstrap and util-linux, and a mirror. Not part of scripts/test.sh, as it
# downloads a system.
set -euo pipefail
cd "$(dirname "$0")/.."
suite=${1:-bookworm}
ls build/release/slalom_*.deb >/dev/null
[ "${SLALOM_PRIVATE_MOUNTS:-}" ] || SLALOM_PRIVATE_MOUNTS=1 exec unshare --mount "$0" "$suite"

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

mkdir "$root/packages"
cp build/release/{slalom,python3-slalom,slalom-doc}_*.deb "$root/packages"
inside apt-get update -qq
# First the dependencies, so that what remains later is of these packages.
names=$(for package in "$root"/packages/*.deb; do dpkg-deb -f "$package" Depends; done |
  tr ',' '\n' | awk '{print $1}' | grep -v '^slalom' | sort -u)
inside apt-get install -qq --no-install-recommends $names >/dev/null
files >"$root/packages/before"
echo "== install"
inside sh -c 'dpkg -i /packages/*.deb' | grep -v '^Selecting\|^(Reading'

echo "== the first campaign of the README"
mkdir "$root/tmp/work"
sed -n '/^## Your first campaign/,/^## /p' README.md | sed -n '/^```ini/,/^```/p' | sed '1d;$d' >"$root/tmp/work/my.ini"
# The method "mine" is the reader's own; one of the package takes its place.
inside sh -c 'cd /tmp/work && slalom-evaluate my.ini -o out -j 2 --quiet --set method.mine.plugin=libslalom_follow_the_gap.so &&
  test -s out/report/index.html && slalom-analyze summary out/runs.results'
echo "== the Python package"
inside sh -c 'cd /tmp/work && python3 -c "
import slalom
scenarios = slalom.generate(\"random\", 5, seed=1)
results = slalom.evaluate({\"gap\": slalom.plugin(\"libslalom_follow_the_gap.so\")}, scenarios)
print(len(scenarios), \"scenarios,\", len(results[\"success\"]), \"runs\")"'
echo "== remove"
inside dpkg --purge python3-slalom slalom-doc slalom | grep -v '^(Reading'
files >"$root/packages/after"
left=$(comm -13 "$root/packages/before" "$root/packages/after" | grep -v '^\./var/lib/dpkg/\|^\./var/log/\|^\./var/cache/' || true)
[ -z "$left" ] || { echo "left behind:"; echo "$left"; exit 1; }
echo "nothing is left"
