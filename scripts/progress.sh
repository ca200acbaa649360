# SPDX-License-Identifier: BSD-3-Clause
# Progress of long commands, for scripts that source this file: a bar with the remaining time on a terminal, elsewhere a
# line for each tenth. All else that the commands print is passed on.

# Reads the output of ninja with NINJA_STATUS='[%f/%t] '.
show_build_progress() {
  local line begin=$SECONDS
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\  ]]; then
      show_part "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" $((SECONDS - begin))
    else
      end_progress
      printf '%s\n' "$line"
    fi
  done
  end_progress
}

# Reads the lines of apt's APT::Status-Fd.
show_apt_progress() {
  local status percent begin=$SECONDS
  while IFS=: read -r status _ percent _; do
    [[ $status =~ ^(pm|dl)status$ && $percent =~ ^[0-9]+ ]] || continue
    show_part "${BASH_REMATCH[0]}" 100 $((SECONDS - begin)) "$status"
  done
  end_progress
}

# show_part DONE TOTAL SECONDS [PHASE]: tenths are counted anew in each phase.
progress_tenth=0 progress_phase="" progress_is_open=0
show_part() {
  local done=$1 total=$2 seconds=$3 left bar text
  [ "${4:-}" = "$progress_phase" ] || progress_tenth=0 progress_phase=${4:-}
  [ "$done" -gt 0 ] || return 0
  left=$((seconds * (total - done) / done))
  text="$((100 * done / total)) %, about $left s left"
  [ "$left" -lt 90 ] || text="$((100 * done / total)) %, about $(((left + 30) / 60)) min left"
  if [ -t 2 ]; then
    printf -v bar '%*s' $((30 * done / total)) ''
    printf '\r\033[K[%-30s] %s' "${bar// /#}" "$text" >&2
    progress_is_open=1
  elif [ $((10 * done / total)) -gt "$progress_tenth" ]; then
    progress_tenth=$((10 * done / total))
    echo "  $text" >&2
  fi
}

end_progress() {
  [ "$progress_is_open" -eq 0 ] || printf '\r\033[K' >&2
  progress_is_open=0
}
