#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the image of examples/container from the packages of scripts/package.sh, prints its size, and runs the first
# campaign of the README and a method in Python in it, in a mounted folder, whose owner must have all files afterwards:
#   scripts/check_container.sh [FOLDER [BASE]]
# FOLDER, default build/release, holds the packages. BASE is an image of Debian for podman to fetch, for example
# docker.io/library/debian:bookworm-slim; without it a new Debian 12 is made on the spot, as root. Images are kept in a
# folder below /tmp, which is removed at the end. Options of the computer are taken from podman's own variables, as
# CONTAINERS_CONF, BUILDAH_ISOLATION and STORAGE_DRIVER. Needs the packages podman and, without BASE, mmdebstrap or
# debootstrap, and a mirror. Not part of scripts/test.sh, as it downloads a system.
set -euo pipefail
sources=$(dirname "$(dirname "$(realpath "$0")")")
source "$sources/scripts/chroot.sh"
[ "${1:-}" != --help ] || { usage && exit 0; }
folder=${1:-$sources/build/release} base=${2:-}
for name in slalom python3-slalom; do
  compgen -G "$folder/${name}_*.deb" >/dev/null || refuse "$folder: no ${name}_*.deb; expected the packages of scripts/package.sh"
done
command -v podman >/dev/null || refuse "needs the package podman"
[ "$base" ] || with_private_mounts "$@"

store=$(mktemp -d /tmp/slalom-container.XXXXXX)
in_store() { podman --root "$store/images" --runroot "$store/run" --tmpdir "$store/tmp" "$@"; }
remove_store() {
  in_store rmi --all --force >/dev/null 2>&1 || true
  umount "$store"/images/* 2>/dev/null || true
  rm -rf "$store"
}
trap remove_store EXIT
if [ -z "$base" ]; then
  new_system bookworm
  trap 'remove_store; remove_system' EXIT
  tar -C "$root" --one-file-system --exclude=./var/lib/apt/lists/* --exclude=./var/cache/apt/* -c . |
    in_store import -q - slalom-base >/dev/null
  base=localhost/slalom-base
fi

start=$SECONDS
in_store build -f "$sources/examples/container/Containerfile" --build-arg "BASE=$base" -t slalom "$folder" >"$store/log" 2>&1 ||
  { cat "$store/log" >&2; exit 1; }
echo "== the image in $(since $start): $(($(in_store image inspect --format '{{.Size}}' slalom) / 1000000)) MB"

# Root's folder is given to another user, since root would own all files anyway.
mkdir "$store/work"
readme_campaign "$sources" >"$store/work/my.ini"
write_python_campaign "$store/work"
if [ "$(id -u)" -eq 0 ]; then owner=12345:12345 options=(); else owner=$(id -u):$(id -g) options=(--userns=keep-id); fi
chown -R "$owner" "$store/work"
in_image() { in_store run --rm "${options[@]}" --user "$owner" -v "$store/work:/work:Z" slalom "$@"; }

start=$SECONDS
# The method "mine" is the reader's own; one of the package takes its place.
in_image slalom-evaluate my.ini -o out -j 2 --quiet --set method.mine.plugin=libslalom_follow_the_gap.so >/dev/null
test -s "$store/work/out/report/index.html"
in_image slalom-analyze summary out/runs.results
echo "== the first campaign of the README in $(since $start)"
start=$SECONDS
in_image slalom-evaluate python.ini -o python -j 2 --quiet >/dev/null
in_image slalom-analyze summary python/runs.results
in_image python3 -c 'import slalom; print(len(slalom.generate("random", 5, seed=1)), "scenarios of the Python package")'
echo "== a report about a method in ten lines of Python in $(since $start)"
foreign=$(find "$store/work" ! \( -uid "${owner%:*}" -gid "${owner#*:}" \))
[ -z "$foreign" ] || { echo "files of others:"; echo "$foreign"; exit 1; }
echo "== all $(find "$store/work" -type f | wc -l) files are the caller's"
