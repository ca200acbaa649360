#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Finds what makes hashes and dumps depend on the C library: check_libm.sh SOURCES BUILD_FOLDER. Libraries and plug-ins
# must not call functions whose last bits IEEE 754 leaves open, nor MRPT's coordinates in frames of poses, whose bits are
# those of its package; sources must not name the former. slalom/core/math.h and slalom/core/pose.h replace them.
set -euo pipefail
sources=$1 build=$2
cd "$sources"

# Modules that may call functions, with the reason: MODULE FUNCTION REASON, a function * is any. A line without a call is
# an error, so that the check cannot pass by finding nothing.
excused='
analysis * statistics of finished runs, which no hash and no dump has
statistics * the same
bags     * frames in three dimensions of recorded robots; scenarios of drives have their poses
gui      * digits of scales on the screen
rawlog   * identification of robots from their logs, maps that MRPT makes of scans
figures  * scales of figures
studio   * digits of scales on the screen
core     exp Boost.Random compares it with a uniform number in 1 of 400 normal ones, and has no other use for it
mppi     exp the same
lcm      exp the same
ompl     exp the same
onnx     exp the same
python   exp the same
ros2     exp the same
ros2_runtime exp the same
'
of_c='sin|cos|tan|sincos|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh'
of_c+='|exp|exp2|exp10|pow10|expm1|log|log2|log10|log1p|pow|hypot|cbrt|erf|erfc|tgamma|lgamma|j[01n]|y[01n]'
complex='cabs|carg|cexp|clog|clog10|csqrt|cpow|csin|ccos|ctan|csinh|ccosh|ctanh|casin|cacos|catan|casinh|cacosh|catanh'
called="($of_c|$complex)[fl]?(_r)?|_ZGV[[:alnum:]]+_[[:alnum:]]+"
called+='|mrpt::(math|poses)::[[:alnum:]:]*([cC]ompose(Point|From)|operator[+-]\().*'
named="std::($of_c|polar)[fl]?[(;]"

# The folder of a module, plug-in or part of a program.
folder_of() {
  case $1 in
    app_*) echo "apps/${1#app_}" ;;
    reactive_common) echo reactive_algos/common ;;
    onnx_runtime) echo adapters/methods/onnx ;;
    ros2_runtime) echo adapters/methods/ros2 ;;
    figures) echo modules/study/report ;;
    *)
      local folder
      for folder in {modules,adapters}/*/"$1" {modules,reactive_algos}/"$1"; do
        [ ! -d "$folder" ] || { echo "$folder"; return; }
      done
      ;;
  esac
}

# "MODULE FUNCTION FILE(OBJECT)" of each undefined symbol that is an inexact function. libslalom.so is made of the modules.
calls() {
  local file module
  for file in "$build"/lib/libslalom_*.a "$build"/lib/slalom/{,runtime/}libslalom_*.so; do
    [ -e "$file" ] || continue
    module=$(basename "$file" | sed -E 's/^libslalom_(.*)\.(a|so)$/\1/; s/_parts$//')
    nm -C -u -A $([[ $file == *.so ]] && echo -D) "$file" 2>/dev/null |
      sed -E 's/^(.*):[[:space:]]+[Uw] /\1 /; s/@.*//' |
      awk -v module="$module" -v path="$file" -v called="^($called)\$" '
        { object = substr($1, length(path) + 2); name = substr($0, length($1) + 2) }
        name ~ called { gsub(" ", "", name); print module, name, path (object == "" ? "" : "(" object ")") }'
  done | sort -u
}

# The functions of FILE(OBJECT) that call NAME.
callers() {
  objdump -d -r -C --no-show-raw-insn "${1%%(*}" | awk -v name="$2" -v object="$(sed -n 's/.*(\(.*\))$/\1/p' <<<"$1")" '
    / file format / { here = object == "" || $1 == object ":" }
    /^[0-9a-f]+ <.*>:$/ { caller = $0; sub(/^[0-9a-f]+ </, "", caller); sub(/>:$/, "", caller) }
    here && caller !~ /@plt/ {
      gsub(" ", ""); sub(/[-+]0x[0-9a-f]+$/, "")
      if (index($0, "<" name "@plt>") || $0 ~ /R_[A-Z0-9_]+/ && substr($0, length($0) - length(name) + 1) == name &&
          substr($0, length($0) - length(name), 1) ~ /[[:space:]]/) print "    called by " caller
    }' | sort -u
}

all=$(calls)
failed=0
while read -r module function file; do
  while read -r known name _; do
    if [[ $known == "$module" && ($name == '*' || $name == "$function") ]]; then continue 2; fi
  done <<<"$excused"
  failed=1
  echo "${file#"$build"/} calls $function"
  callers "$file" "$function"
  folder=$(folder_of "$module")
  word=$(sed -E 's/.*:://; s/\(.*//; s/[fl]$//' <<<"$function")
  [ -z "$folder" ] || grep -rnE --include='*.cpp' --include='*.h' "(^|[^[:alnum:]_:]|std::)${word}[fl]?\\(" "$folder" |
    sed 's/^/    /' || true
done <<<"$all"

off_path=()
while read -r module function reason; do
  [ -n "$module" ] || continue
  [ "$function" = '*' ] && off_path+=("$(folder_of "$module")")
  [[ -d $(folder_of "$module") ]] || { echo "No module $module"; failed=1; }
  if ! awk -v m="$module" -v f="$function" '$1 == m && (f == "*" || $2 == f) { n = 1 } END { exit !n }' <<<"$all" &&
     [ -e "$build/lib/libslalom_$module.a" ]; then
    echo "$module is excused for $function ($reason), but calls none"
    failed=1
  fi
done <<<"$excused"

found=$(grep -rnE "$named" modules adapters reactive_algos apps --include='*.cpp' --include='*.h' --include='*.hpp' |
  grep -vE "^($(IFS='|'; echo "${off_path[*]}"))/" || true)
if [ -n "$found" ]; then
  echo "Sources name functions of the C library; slalom/core/math.h has their replacements:"
  echo "$found"
  failed=1
fi
[ $failed -eq 0 ] && echo "No call outside of $(grep -c . <<<"$excused") excuses, $(grep -c . <<<"$all") inside"
exit $failed
