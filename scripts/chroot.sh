# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Functions of check_archive.sh, check_container.sh and check_packages.sh, which source this file: a new Debian system in
# $root.
refuse() {
  echo "$(basename "$0"): $1" >&2
  exit 2
}

usage() { sed -n '3,/^set /{/^set /d; s/^# \{0,1\}//; p}' "$0"; }

expect_suite() {
  [[ $1 =~ ^[a-z]+$ ]] || refuse "$1: expected the code name of a release, for example trixie"
}

# Starts the script again, as root with mounts of its own, unless it has them.
with_private_mounts() {
  [ "$(id -u)" -eq 0 ] || refuse "a chroot is made by root only; use sudo"
  [ "${SLALOM_PRIVATE_MOUNTS:-}" ] || SLALOM_PRIVATE_MOUNTS=1 exec unshare --mount "$0" "$@"
}

remove_system() {
  umount "$root/proc" 2>/dev/null || true
  rm -rf "$root"
}

# Sets root to the folder of a new system, SUITE of Debian or an LTS release of Ubuntu, which is removed at the end:
# new_system SUITE [MIRROR].
new_system() {
  local suite=$1 mirror=http://deb.debian.org/debian ubuntu=
  case $suite in
    focal | jammy | noble | resolute) ubuntu=1 mirror=http://archive.ubuntu.com/ubuntu ;;
  esac
  mirror=${2:-$mirror}
  root=$(mktemp -d /tmp/slalom-chroot.XXXXXX)
  trap remove_system EXIT
  chmod 755 "$root"
  echo "== a new system: $suite"
  if [ "$ubuntu" ]; then
    # A debootstrap older than the release lacks its name; all releases of Ubuntu are made like this one.
    debootstrap --variant=minbase --components=main,universe "$suite" "$root" "$mirror" gutsy >/dev/null
  elif command -v mmdebstrap >/dev/null; then
    mmdebstrap --quiet --variant=apt "$suite" "$root" "$mirror"
  else
    debootstrap --variant=minbase "$suite" "$root" "$mirror" >/dev/null
  fi
  mount -t proc proc "$root/proc"
}

inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C DEBIAN_FRONTEND=noninteractive "$@"; }
since() { echo "$((SECONDS - $1)) s"; }

# The first campaign of the README.
readme_campaign() { sed -n '/^## Your first campaign/,/^## /p' "$1/README.md" | sed -n '/^```ini/,/^```/p' | sed '1d;$d'; }

# Writes the folder of a method in ten lines of Python, and of a campaign of it and one of MRPT.
write_python_campaign() {
  cat >"$1/my_method.py" <<'PYTHON'
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
  cat >"$1/python.ini" <<'CAMPAIGN'
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
}
