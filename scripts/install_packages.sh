#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the missing packages of scripts/packages.txt with apt (with sudo unless root). With --tests also those packages
# of scripts/packages_test.txt that the distribution provides.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source "$here/apt.sh"
source "$here/progress.sh"

missing=() optional=()
for package in $(packages_of "$here/packages.txt"); do
  is_installed "$package" || missing+=("$package")
done
if [ "${1:-}" = --tests ]; then
  for package in $(packages_of "$here/packages_test.txt"); do
    is_installed "$package" || optional+=("$package")
  done
fi
[ ${#missing[@]} -eq 0 ] && [ ${#optional[@]} -eq 0 ] && exit 0

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
export DEBIAN_FRONTEND=noninteractive
echo "Reading the lists of packages" >&2
"${as_root[@]}" apt-get update -qq
absent=()
for package in "${missing[@]}"; do
  is_available "$package" || absent+=("$package")
done
if [ ${#absent[@]} -gt 0 ]; then
  echo "Not available here: ${absent[*]}" >&2
  echo "Slalom is built on Debian 12 or 13; its archive runs on any x86-64 Linux: docs/start/install.md" >&2
  exit 1
fi
for package in "${optional[@]}"; do
  if is_available "$package"; then
    missing+=("$package")
  else
    echo "Not available here, tests that need it are skipped: $package" >&2
  fi
done
[ ${#missing[@]} -eq 0 ] && exit 0
echo "Installing ${#missing[@]} packages: ${missing[*]}" >&2
# Standard output, since sudo closes all other descriptors; what else apt prints there is passed over.
"${as_root[@]}" apt-get install -y --no-install-recommends -qq -o APT::Status-Fd=1 "${missing[@]}" | show_apt_progress
