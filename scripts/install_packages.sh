#!/usr/bin/env bash
# Installs what is missing of scripts/packages.txt with apt; does nothing when all is there. With --tests also what
# the distribution has of scripts/packages_test.txt.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

packages_of() { grep -v '^#' "$1"; }

is_installed() {
  local status
  status=$(dpkg-query -W -f='${Status}' "$1" 2>/dev/null || true)
  [ "$status" = "install ok installed" ]
}

missing=() wished=()
for package in $(packages_of "$here/packages.txt"); do
  is_installed "$package" || missing+=("$package")
done
if [ "${1:-}" = --tests ]; then
  for package in $(packages_of "$here/packages_test.txt"); do
    is_installed "$package" || wished+=("$package")
  done
fi
[ ${#missing[@]} -eq 0 ] && [ ${#wished[@]} -eq 0 ] && exit 0

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
for package in "${wished[@]}"; do
  apt-cache policy "$package" | grep -q 'Candidate: [^(]' && missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0
echo "Installing: ${missing[*]}" >&2
"${as_root[@]}" apt-get install -y --no-install-recommends -qq "${missing[@]}" >/dev/null
