#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Unpacks the archive of scripts/archive.sh in a new system below /tmp, without installing any package there, and runs
# campaigns as an ordinary user:
#   scripts/check_archive.sh [SUITE [ARCHIVE [MIRROR]]]
# Environment variables: BUNDLES, a folder with bundles that are verified there, such as FOLDER/slalom-standard of
# scripts/baselines.sh FOLDER; FRACTION, the part of their scenarios (0.02).
# SUITE is the code name of a release of Debian, default trixie (Debian 13), or of Ubuntu, noble (24.04) or resolute (26.04).
# ARCHIVE is by default that of build/release, MIRROR that of the distribution; Ubuntu's signatures are checked only where
# its keyring is installed. The folder has a space in its name. Checked are the first campaign of the README with its
# report, a method in Python, tables and the help of a program. Runs as root; needs the packages debootstrap (for Debian,
# or mmdebstrap), util-linux and zstd. Not part of scripts/test.sh, as it downloads a system.
set -euo pipefail
sources=$(dirname "$(dirname "$(realpath "$0")")")
source "$sources/scripts/chroot.sh"
[ "${1:-}" != --help ] || { usage && exit 0; }
suite=${1:-trixie} archive=${2:-$(compgen -G "$sources/build/release/slalom-*-x86_64.tar.zst" || true)} mirror=${3:-}
expect_suite "$suite"
[ -f "$archive" ] || refuse "${archive:-$sources/build/release}: no archive; expected that of scripts/archive.sh"
with_private_mounts "$suite" "$archive" "$mirror"

new_system "$suite" "$mirror"
inside useradd --create-home user
as_user() { chroot --userspec=user:user "$root" /usr/bin/env -i PATH=/usr/bin:/bin HOME=/home/user LC_ALL=C "$@"; }
home="$root/home/user"
start=$SECONDS
as_user mkdir "/home/user/my programs" /home/user/work
zstd -dcq "$archive" | as_user tar -C "/home/user/my programs" -x
echo "== unpacked in $(since $start): $(du -sm "$home/my programs" | cut -f1) MB"
missing=$(as_user sh -c 'for file in "/home/user/my programs"/slalom-*/bin/*; do ldd "$file" | grep "not found"; done' || true)
[ -z "$missing" ] || { echo "missing libraries:"; sort -u <<<"$missing"; exit 1; }

start=$SECONDS
readme_campaign "$sources" >"$home/work/my.ini"
write_python_campaign "$home/work"
# The method "mine" is the reader's own; one of the archive takes its place.
as_user sh -c 'PATH="$(echo "/home/user/my programs"/slalom-*/bin):$PATH" && cd /home/user/work &&
  slalom-evaluate my.ini -o out -j 2 --quiet --set method.mine.plugin=libslalom_follow_the_gap.so &&
  test -s out/report/index.html && slalom-analyze summary out/runs.results && slalom-tune --help | head -3'
echo "== the first campaign of the README in $(since $start)"
start=$SECONDS
as_user sh -c 'PATH="$(echo "/home/user/my programs"/slalom-*/bin):$PATH" && cd /home/user/work &&
  slalom-evaluate python.ini -o python -j 2 --quiet && test -s python/report/index.html &&
  slalom-analyze summary python/runs.results'
echo "== a report about a method in ten lines of Python in $(since $start)"
if [ "${BUNDLES:-}" ]; then
  start=$SECONDS
  cp "$BUNDLES"/*.slalom "$home/work"
  as_user sh -c 'PATH="$(echo "/home/user/my programs"/slalom-*/bin):$PATH" && cd /home/user/work && set -e &&
    for bundle in *.slalom; do echo "$bundle: $(slalom-simulate verify "$bundle" --fraction '"${FRACTION:-0.02}"' -j 0 --quiet | tail -1)"; done'
  echo "== bundles in $(since $start)"
fi
as_user rm -r "/home/user/my programs"
left=$(as_user find /home/user -mindepth 1 -maxdepth 1 ! -name '.*' ! -name work)
[ -z "$left" ] || { echo "left behind:"; echo "$left"; exit 1; }
echo "== removed: nothing is left"
