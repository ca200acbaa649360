# SPDX-License-Identifier: BSD-3-Clause
# Questions to the package database, for scripts that source this file.

# The names in a list of packages.
packages_of() { grep -v '^#' "$1"; }

is_installed() {
  local status
  status=$(dpkg-query -W -f='${Status}' "$1" 2>/dev/null || true)
  [ "$status" = "install ok installed" ]
}

# Whether the distribution has the package. The text is matched here and not in a pipe: a reader that ends early would
# make the pipe fail under `set -o pipefail`.
is_available() {
  local policy
  policy=$(LC_ALL=C apt-cache policy "$1" 2>/dev/null || true)
  [[ $policy =~ Candidate:\ [^\(] ]]
}
