# SPDX-License-Identifier: BSD-3-Clause
# Common functions of the scripts of the groups and the test on a Slurm cluster.

# A case for the table of scripts/faults.sh: report CASE EXPECTED SEEN.
report() { printf '%s\t%s\t%s\n' "$1" "$2" "$3"; }

# The digest of all values of a result file.
digest() { slalom-analyze dump "$1" 2>/dev/null | md5sum | cut -d' ' -f1; }

# The sections of an .ini for COUNT small scenarios: small_scenarios COUNT.
small_scenarios() {
  printf '[scenarios]\ngenerator = random\ncount = %s\n' "$1"
  printf '[generator.random]\nwidth = 6\nheight = 6\nmin_distance = 3\nmax_obstacles = 10\nmax_size = 0.4\n'
}

# The section of a shipped method: method_section nd|gap.
method_section() {
  case $1 in
    nd) printf '[method.nd]\nadapter = mrpt_holonomic\nclass = CHolonomicND\n' ;;
    gap) printf '[method.gap]\nadapter = library\nplugin = libslalom_follow_the_gap.so\n' ;;
  esac
}
