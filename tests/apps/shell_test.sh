#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Completion and manual pages of the programs in BUILD/bin: shell_test.sh BUILD_FOLDER
set -uo pipefail
build=$1
export PATH=$build/bin:$PATH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failed=0
expect() {
  local name=$1
  shift
  if "$@"; then echo "ok: $name"; else echo "FAILED: $name"; failed=1; fi
}
same() { [ "$1" = "$2" ] || { printf 'expected: %s\ngot: %s\n' "$2" "$1"; false; }; }

cat >my.ini <<'INI'
[campaign]
methods = fast, slow
[scenarios]
generator = random
[method.fast]
adapter = mrpt_holonomic
class = CHolonomicND
[method.slow]
adapter = mrpt_holonomic
class = CHolonomicVFF
INI

# Every line of --help that names an option or a verb, without its explanation.
described() { sed -nE 's/^  (-[^ ]*|[a-z]+).*/\1/p'; }
page_of() { groff -ww -man -Tascii -P-c -P-b -P-u -rLL=400n "$1" 2>>"$work/complaints"; }
help_is_in_page() {
  local help text
  help=$("$@" --help) || return 1
  # The names, and the explanations as they are: lines are not broken in the page.
  { described <<<"$help"; sed -nE 's/^ {2}.* {2,}([A-Z].*)/\1/p' <<<"$help"; } >"$work/described"
  [ -s "$work/described" ] || return 1
  while read -r text; do
    [[ $page == *"$text"* ]] || { echo "no '$text' of '$* --help'" && return 1; }
  done <"$work/described"
}
for program in "$build"/completion/slalom-*; do
  program=$(basename "$program")
  "$program" --man-page >"$work/page.1" || failed=1
  : >"$work/complaints"
  page=$(page_of "$work/page.1" | tr -s ' ')
  expect "$program.1 is formatted without a complaint" same "$(cat "$work/complaints")" ""
  expect "$program.1 has the help" help_is_in_page "$program"
  for verb in $("$program" --complete ""); do
    expect "$program.1 has the help of $verb" help_is_in_page "$program" "$verb"
  done
done

# Words that bash proposes for a line, which is split as bash does.
completed() {
  bash --norc -c 'source "$1/completion/$2"
    compopt() { :; }
    COMP_LINE=$3; COMP_POINT=${#3}
    read -ra COMP_WORDS <<<"${3//=/ = }"
    [[ $3 == *" " ]] && COMP_WORDS+=("")
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    _slalom "$2"; echo "${COMPREPLY[*]}"' - "$build" "${1%% *}" "$1"
}
expect_bash() { expect "bash: $1" same "$(completed "$1")" "$2"; }
expect_bash "slalom-scenarios ge" "generate"
expect_bash "slalom-scenarios index cr" "create"
expect_bash "slalom-scenarios generate --ov" "--overwrite"
expect_bash "slalom-scenarios describe a.scenarios --descriptors density,clu" "density,clustering"
expect_bash "slalom-scenarios convert a.scenarios --to " "continuous grid points"
expect_bash "slalom-scenarios generate --set scenarios.generator=ra" "random"
expect_bash "slalom-scenarios generate --set generator.maze.wa" "generator.maze.wall="
expect_bash "slalom-evaluate my.ini --set metrics.enabled=opt" "optimality optimality_area optisafe"
expect_bash "slalom-evaluate my.ini --set campaign.methods=" "fast slow"
expect_bash "slalom-evaluate my.ini --set method.fast.adapter=l" "library lcm"
expect_bash "slalom-evaluate my.ini --set method.fast.plugin=libslalom_mp" "libslalom_mppi.so"
expect_bash "slalom-lcm-method --plugin libslalom_fo" \
  "libslalom_follow_the_gap.so libslalom_follow_the_gap_holonomic.so"
expect_bash "slalom-analyze table my.ini --method s" "slow"
expect_bash "slalom-certify limit my.ini --method s" "slow"
expect_bash "slalom-certify limit my.ini --of passage.wi" "passage.width"
expect_bash "slalom-tune my.ini --method s" "slow"
expect_bash "slalom-falsify search my.ini --method s" "slow"
expect_bash "slalom-falsify search my.ini --method slow --surrogate f" "fast"
expect_bash "slalom-falsify shrink a.scenario.yaml -c my.ini --witness " "fast slow"
expect_bash "slalom-replay check a.rawlog -c my.ini --method s" "slow"
expect_bash "slalom-replay openloop a.rawlog -c my.ini --method f" "fast"
expect_bash "slalom-analyze ta" "table"
expect_bash "slalom-analyze table missing.ini --method s" ""
expect_bash "slalom-evaluate my" ""

# All metrics and generators are proposed that the program has.
names() { "$@" | sed 's/.*=//' | sort | paste -sd' '; }
expect "all generators" same "$(names slalom-scenarios --complete generate --set scenarios.generator=)" \
  "$(slalom-evaluate --options | sed -nE 's/^\[generator\.(.*)\]/\1/p' | sort | paste -sd' ')"

if command -v zsh >/dev/null; then
  # zsh's functions for candidates and files are replaced by ones that print.
  proposed() {
    zsh -fc 'compadd() { [[ $1 = -S ]] && shift 2; [[ $1 = -a ]] && print -r -- ${(P)2} }
      _files() { print files }
      words=(${(s: :)3}); [[ $3 = *" " ]] && words+=("")
      CURRENT=$#words PREFIX=${words[-1]}
      _complete_it() { source $1/completion/_slalom }
      _complete_it $1' - "$build" "" "$1" | paste -sd' ' | sed 's/^ *//; s/ *$//'
  }
  expect_zsh() { expect "zsh: $1" same "$(proposed "$1")" "$2"; }
  expect_zsh "slalom-scenarios ge" "generate"
  expect_zsh "slalom-scenarios generate --set scenarios.generator=ra" "scenarios.generator=random"
  expect_zsh "slalom-scenarios generate --set generator.maze.wa" "generator.maze.wall="
  expect_zsh "slalom-analyze table my.ini --method s" "slow"
  expect_zsh "slalom-evaluate my" "files"
else
  echo "needs the package zsh"
fi
exit $failed
