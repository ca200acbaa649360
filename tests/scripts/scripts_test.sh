#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Tests of scripts/ that run in a second, with a package database and test logs made up here: scripts_test.sh SOURCES
set -uo pipefail
sources=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
expect() {
  local name=$1
  shift
  if "$@"; then echo "ok: $name"; else echo "FAILED: $name"; failed=1; fi
}
not() { ! "$@"; }
expect_text() { expect "$1" grep -qF -- "$2" "$3"; }

# A database that answers at length, as the real one does: a reader that ends early breaks its pipe.
mkdir "$work/bin" "$work/build"
cat >"$work/bin/apt-cache" <<'SCRIPT'
#!/usr/bin/env bash
case $2 in
  present) echo "present:"; echo "  Candidate: 1.0" ;;
  *) echo "$2:"; echo "  Candidate: (none)" ;;
esac
for i in {1..5000}; do echo "  500 http://deb.example.org stable/main Packages $i"; done
SCRIPT
chmod +x "$work/bin/apt-cache"
PATH="$work/bin:$PATH"
source "$sources/scripts/apt.sh"
# The citation is of this version, with the keys that its format requires.
version=$(sed -n 's/^project(slalom VERSION \([0-9.]*\).*/\1/p' "$sources/CMakeLists.txt")
expect_text "CITATION.cff cites this version" "version: $version" "$sources/CITATION.cff"
for key in cff-version message title authors; do
  expect "CITATION.cff has $key" grep -q "^$key:" "$sources/CITATION.cff"
done
always_available() { for _ in {1..20}; do is_available present || return 1; done; }
expect "a package that the distribution has is available, each time" always_available
expect "a package without a candidate is not" not is_available absent

# A system without MRPT, as Ubuntu 24.04.
mkdir "$work/ubuntu"
cp "$work/bin/apt-cache" "$work/ubuntu"
sed -i 's/^  present)/  libmrpt-dev) echo "$2:"; echo "  Candidate: (none)" ;;\n  *)/; /^  \*) echo .*none/d' "$work/ubuntu/apt-cache"
printf '#!/bin/sh\necho "$@" >>"%s/calls"\n' "$work" | tee "$work/ubuntu/apt-get" "$work/ubuntu/sudo" >/dev/null
printf '#!/bin/sh\nexit 1\n' >"$work/ubuntu/dpkg-query"
chmod +x "$work"/ubuntu/*
PATH="$work/ubuntu:$PATH" "$sources/scripts/install_packages.sh" >"$work/out" 2>"$work/err"
expect "a system without MRPT is an error" test $? = 1
expect_text "which names what is missing, and no more" "Not available here: libmrpt-dev" <(grep -x 'Not.*mrpt-dev' "$work/err")
expect_text "and the way to take" "its archive runs on any x86-64 Linux: docs/start/install.md" "$work/err"
expect "nothing is installed there" not grep -q install "$work/calls"

# Progress: a line for each tenth, and all else that the build says.
source "$sources/scripts/progress.sh"
{ for i in {1..40}; do echo "[$i/40] Building CXX object x.o"; done; echo "x.cpp:1: warning: unused"; } |
  show_build_progress >"$work/out" 2>"$work/err"
expect "a build shows ten lines of progress" test "$(wc -l <"$work/err")" = 10
expect "the last one is the end" grep -q "100 %" <(tail -n 1 "$work/err")
expect "warnings are passed on" test "$(cat "$work/out")" = "x.cpp:1: warning: unused"
printf '%s\n' dlstatus:1:100.0:Get pmstatus:a:50.0:Unpack pmstatus:a:100.0:Setup |
  show_apt_progress >"$work/out" 2>"$work/err"
expect "downloads and installation are counted apart" test "$(grep -c % "$work/err")" = 3
"$sources/scripts/test.sh" --everything >"$work/out" 2>"$work/err"
expect "an unknown option of test.sh is an error" test $? = 2
expect_text "which names the valid one" "[--all]" "$work/err"

log="$work/build/Testing/Temporary/LastTest.log"
mkdir -p "$(dirname "$log")"
run_report() { "$sources/scripts/report_skipped.sh" "$work/build" >"$work/out" 2>"$work/err"; }

cat >"$log" <<'LOG'
1/1 Test: Suite.Passes
Output:
[       OK ] Suite.Passes (0 ms)
Test Passed.
LOG
expect "nothing is reported when nothing was skipped" run_report
expect "the report is empty then" test ! -s "$work/out"

cat >"$log" <<'LOG'
1/2 Test: Window.Opens
Output:
[ RUN      ] Window.Opens
/src/window_test.cpp:17: Skipped
needs the package absent

[  SKIPPED ] Window.Opens (3 ms)
Test Skipped.
2/2 Test: Network.IsPrivate
Output:
Skipped: neither a private network nor one with multicast
Test Skipped.
LOG
expect "a package that the distribution lacks is a good reason" run_report
expect_text "the reason is printed" "Window.Opens: needs the package absent" "$work/out"
expect_text "reasons of other programs too" "Network.IsPrivate: neither a private network" "$work/out"

sed -i 's/package absent/package present/' "$log"
expect "a package that the distribution has is not" not run_report

check_platform() { "$sources/scripts/check_platform.sh" "$@" >"$work/out" 2>"$work/err"; }
refuses() {
  local text=$1
  shift
  check_platform "$@"
  [ $? -eq 2 ] && grep -qF -- "$text" "$work/err"
}
expect "the check of a platform explains itself" check_platform --help
expect_text "by its options" "[--folder DIR]" "$work/out"
expect_text "to the last line" "by scripts/check_arm64.sh." "$work/out"
expect "it refuses a missing name" refuses "expected the code name"
expect "it refuses a path for a name" refuses "../trixie: expected the code name" ../trixie
expect "it refuses no processes" refuses "--jobs 0: expected a number of processes" --jobs 0 trixie
expect "it refuses an option without its value" refuses "--folder: expected a value" --folder
expect "it refuses an unknown option" refuses "unknown option --fodler" --fodler /tmp trixie
expect "packages and tests exclude each other" refuses "-R: --packages runs no tests" --packages trixie -R Golden
expect "arm64 has no packages" refuses "--packages: arm64 has emulated programs" --packages arm64
expect "arm64 has no tests of ctest" refuses "-R: arm64 runs no tests of ctest" arm64 -R Golden

document="$work/page.md"
printf '%s\n' '# A page' '[here](#a-page), [there](page.md)' '`mover`, "a mover"' '```' 'mended' '```' >"$document"
check_documents() { "$sources/scripts/check_documents.py" "$document" >"$work/out"; }
expect "code, quotes and links that lead somewhere are good in documents" check_documents
printf '%s\n' 'It was mended.' 'Two movers.' '[this](#no-page)' '[that](none.md)' >>"$document"
expect "words of a laboratory notebook and broken links are not" not check_documents
expect_text "the history of a defect has its line" "page.md:7: 'mended'" "$work/out"
expect_text "so has a word that is not that of the field" "page.md:8: 'movers': moving obstacle" "$work/out"
expect_text "a link to a missing heading" "page.md:9: (#no-page): no such heading" "$work/out"
expect_text "a link to a missing file" "page.md:10: (none.md): no such file" "$work/out"

printf '%s\n' '// Returns a length.' 'int a;  // of a wall' '/// A length,' '/// what else.' >"$work/good.h"
check_comments() { "$sources/scripts/check_comments.py" "$1" >"$work/out"; }
expect "nouns, verbs and later lines are good in comments" check_comments "$work/good.h"
printf '%s\n' 'int a;' '/// What it does.' 'int b;  ///< Of walls.' >"$work/bad.h"
expect "comments without a head are not" not check_comments "$work/bad.h"
expect_text "one above code has its line" "bad.h:2: headless: What it does." "$work/out"
expect_text "one behind code too" "bad.h:3: headless: Of walls." "$work/out"

# Programs without those of Clang.
mkdir "$work/tools"
for tool in bash dirname env git grep; do ln -s "$(command -v "$tool")" "$work/tools"; done
for check in check_format check_tidy; do
  without_clang() { env -u CI PATH="$work/tools" "$@" "$sources/scripts/$check.sh" >"$work/out" 2>&1; }
  expect "$check.sh checks nothing without its version of Clang" without_clang
  expect "it fails in continuous integration then" not without_clang CI=true
done

hooks=$(sed -n 's/^ *entry: //p' "$sources/.pre-commit-config.yaml")
expect "there are hooks of pre-commit" test -n "$hooks"
for hook in $hooks; do expect "the hook $hook is a program" test -x "$sources/$hook"; done

tree="$work/tree"
mkdir -p "$tree"/{adapters,apps} "$tree"/modules/{low,high}/{include/slalom,src}
mkdir "$tree"/modules/{low/include/slalom/low,high/include/slalom/high}
echo 'slalom_add_module(low SOURCES src/low.cpp)' >"$tree/modules/low/CMakeLists.txt"
echo 'slalom_add_module(high SOURCES src/top.cpp DEPENDS low)' >"$tree/modules/high/CMakeLists.txt"
touch "$tree"/modules/low/include/slalom/low/{low,side}.h "$tree/modules/high/include/slalom/high/top.h"
echo '#include <slalom/high/top.h>' >"$tree/modules/high/src/helper.h"
printf '%s\n' '#include "helper.h"' '#include <slalom/low/low.h>' >"$tree/modules/high/src/top.cpp"
check_includes() { "$sources/scripts/check_includes.py" "$tree" >"$work/out"; }
expect "dependencies, and private headers behind a public one, are good includes" check_includes
echo '#include <slalom/high/top.h>' >"$tree/modules/low/src/low.cpp"
echo '#include <slalom/low/side.h>' >>"$tree/modules/low/src/low.cpp"
echo '#include <slalom/low/low.h>' >"$tree/modules/low/src/side.cpp"
expect "includes upwards and in a circle are not" not check_includes
expect_text "the file and the module that it must not include" "modules/low/src/low.cpp: high is not in" "$work/out"
expect_text "the components of a circle" "modules/low/low -> modules/low/side -> modules/low/low" "$work/out"
echo 'slalom_add_module(low SOURCES src/low.cpp DEPENDS high)' >"$tree/modules/low/CMakeLists.txt"
expect "dependencies in a circle are not" not check_includes
expect_text "its modules" "modules/high -> modules/low -> modules/high" "$work/out"
echo 'slalom_add_module(low SOURCES src/low.cpp)' >"$tree/modules/low/CMakeLists.txt"
printf '%s\n' 'add_subdirectory(top)' 'add_subdirectory(bottom)' >"$tree/modules/CMakeLists.txt"
mkdir "$tree"/modules/{top,bottom}
mv "$tree/modules/high" "$tree/modules/top/high"
mv "$tree/modules/low" "$tree/modules/bottom/low"
expect "a module that depends on a package after its own is not" not check_includes
expect_text "the module and what it depends on" "modules/top/high: low is in a package above it" "$work/out"
expect_text "the packages with their modules" "1 top: high" "$work/out"
mv "$tree/modules/top/high" "$tree/modules/bottom/low" "$tree/modules"
rm -r "$tree/modules/CMakeLists.txt" "$tree"/modules/{top,bottom}
printf '%s\n' 'namespace slalom {' 'namespace {' 'struct Own {' '};' '}  // namespace' 'struct Part {' '};' \
  'struct Part::Impl {' '};' '}  // namespace slalom' | tee "$tree/modules/low/src/low.cpp" >"$tree/modules/high/src/top.cpp"
expect "two definitions of a class are not" not check_includes
expect_text "the class and its sources" \
  "slalom::Part is defined in modules/high/src/top.cpp and modules/low/src/low.cpp" "$work/out"
expect "classes of unnamed namespaces may have equal names" not grep -q Own "$work/out"

mkdir -p "$tree/.ci" "$tree/tests" "$tree/docs" "$tree/bin"
printf '%s\n' 'product_lines 99' 'test_lines 2' 'public_headers 9' 'document_words 3' 'verbs 1' 'flags 4' 'keys 2' >"$tree/.ci/budget"
printf '1\n2\n' >"$tree/tests/a_test.cpp"
echo "three words here" >"$tree/docs/page.md"
cat >"$tree/bin/slalom-evaluate" <<'PROGRAM'
#!/bin/sh
case "$*" in
  --help) printf 'Options:\n  -h,--help  Help\n  --version  Version\nSubcommands:\n  run  Runs\n' ;;
  "run --help") printf 'Options:\n  -h,--help  Help\n  --seed INT  Seed\n  -j,--jobs INT  Workers\n' ;;
  --options) printf '[campaign]\n  name = x  the name\n  seed = 1  the seed\n' ;;
esac
PROGRAM
chmod +x "$tree/bin/slalom-evaluate"
git -C "$tree" init -q && git -C "$tree" add .
check_budget() { "$sources/scripts/check_budget.py" "$tree" "$tree/bin" >"$work/out"; }
expect "a project within its budget passes" check_budget
for size in "test_lines 2" "document_words 3" "verbs 1" "flags 4" "keys 2"; do
  expect_text "${size% *} are counted" "${size#* } of" <(grep "^${size% *} " "$work/out")
done
echo "and two" >>"$tree/docs/page.md"
expect "a larger one does not" not check_budget
expect_text "what is too large" "5 of       3  too large" "$work/out"

check_packages() { "$sources/scripts/check_packages.sh" "$@" >"$work/out" 2>"$work/err"; }
refuses_packages() {
  local text=$1
  shift
  check_packages "$@"
  [ $? -eq 2 ] && grep -qF -- "$text" "$work/err"
}
expect "the check of packages explains itself" check_packages --help
expect_text "to the last line" "as it downloads a system." "$work/out"
expect "it refuses a path for a name" refuses_packages "../trixie: expected the code name" ../trixie "$work"
expect "it refuses a folder without packages" refuses_packages "$work: no slalom_*.deb" trixie "$work"

check_container() { "$sources/scripts/check_container.sh" "$@" >"$work/out" 2>"$work/err"; }
refuses_container() {
  local text=$1
  shift
  check_container "$@"
  [ $? -eq 2 ] && grep -qF -- "$text" "$work/err"
}
expect "the check of the container explains itself" check_container --help
expect_text "to the last line" "as it downloads a system." "$work/out"
expect "it refuses a folder without packages" refuses_container "$work: no slalom_*.deb" "$work"

check_archive() { "$sources/scripts/check_archive.sh" "$@" >"$work/out" 2>"$work/err"; }
refuses_archive() {
  local text=$1
  shift
  check_archive "$@"
  [ $? -eq 2 ] && grep -qF -- "$text" "$work/err"
}
expect "the check of the archive explains itself" check_archive --help
expect_text "to the last line" "as it downloads a system." "$work/out"
expect "it refuses a path for a name" refuses_archive "../trixie: expected the code name" ../trixie
expect "it refuses a missing archive" refuses_archive "$work/none.tar.zst: no archive" trixie "$work/none.tar.zst"
# The archive's programs start with its own glibc where that of the system is older, or is none.
mkdir -p "$work/a prefix/bin" "$work/a prefix/lib/slalom/programs" "$work/a prefix/lib/slalom/glibc"
launcher="$work/a prefix/bin/slalom-x" own="$work/a prefix/lib/slalom/glibc"
sed 's/@MINOR@/36/' "$sources/scripts/launcher.sh" >"$launcher"
printf '#!/bin/sh\necho "as it is: $1"; exit 3\n' >"$work/a prefix/lib/slalom/programs/slalom-x"
printf '#!/bin/sh\necho "by its own: $*"\n' >"$own/ld-linux-x86-64.so.2"
chmod +x "$launcher" "$own"/* "$work/a prefix/lib/slalom/programs/slalom-x"
launch() {
  printf '#!/bin/sh\necho "%s"\n' "$1" >"$work/ubuntu/getconf" && chmod +x "$work/ubuntu/getconf"
  PATH="$work/ubuntu:$PATH" "$launcher" "a b" >"$work/out"
}
launch "glibc 2.36"
expect "a launcher gives the exit status of the program" test $? = 3
expect "which runs as it is with a new glibc" test "$(cat "$work/out")" = "as it is: a b"
for version in "glibc 2.35" "glibc 2.4" ""; do
  launch "$version"
  expect "and by the archive's own with '$version'" \
    test "$(cat "$work/out")" = "by its own: --library-path $own $work/a prefix/lib/slalom/programs/slalom-x a b"
done
make_archive() { "$sources/scripts/archive.sh" "$@" >"$work/out" 2>"$work/err"; }
expect "the archive explains itself" make_archive --help
expect_text "to the last line" "Needs the packages binutils, patchelf and zstd." "$work/out"
expect "it refuses an argument" not make_archive trixie
expect_text "and names it" "archive.sh: trixie: expected no argument" "$work/err"

# A wheel lists each file with its hash, and keeps what may be executed; the same files give the same wheel.
mkdir -p "$work/package/slalom/bundle/bin" "$work/first" "$work/second"
printf 'text' >"$work/package/slalom/__init__.py"
cp /bin/true "$work/package/slalom/bundle/bin/slalom-program"
make_wheel() { /usr/bin/python3 "$sources/scripts/wheel.py" "$work/package" 1.2.3 36 946684800 "$1" >/dev/null; }
expect "a wheel is written" make_wheel "$work/first"
touch "$work/package/slalom/__init__.py" && make_wheel "$work/second"
wheel=$(basename "$work"/first/*.whl)
expect "with its platform in the name" grep -q '^slalom-1.2.3-py3-none-manylinux_2_36_x86_64.whl$' <<<"$wheel"
expect "the same twice" cmp "$work/first/$wheel" "$work/second/$wheel"
wheel_is_right() {
  /usr/bin/python3 - "$work/first/$wheel" <<'PYTHON'
import base64, csv, hashlib, sys, zipfile
wheel = zipfile.ZipFile(sys.argv[1])
rows = {name: digest for name, digest, _ in csv.reader(wheel.read("slalom-1.2.3.dist-info/RECORD").decode().splitlines())}
assert set(rows) == set(wheel.namelist())
# The hash of PEP 427: urlsafe base64 without padding.
digest = base64.urlsafe_b64encode(hashlib.sha256(b"text").digest()).rstrip(b"=").decode()
assert rows["slalom/__init__.py"] == "sha256=" + digest
assert wheel.getinfo("slalom/bundle/bin/slalom-program").external_attr >> 16 & 0o111 == 0o111
assert wheel.read("slalom-1.2.3.data/scripts/slalom-program").startswith(b"#!python\n")
assert wheel.getinfo("slalom/__init__.py").external_attr >> 16 & 0o111 == 0
PYTHON
}
expect "its record has all files and their hashes, and programs may be executed" wheel_is_right
make_a_wheel() { "$sources/scripts/wheel.sh" "$@" >"$work/out" 2>"$work/err"; }
expect "the wheel explains itself" make_a_wheel --help
expect_text "to the last line" "Needs the packages patchelf and binutils." "$work/out"
expect "it refuses an argument" not make_a_wheel trixie
expect_text "and names it" "wheel.sh: trixie: expected no argument" "$work/err"

# Binaries are found by their first bytes, not by names.
source "$sources/scripts/bundle.sh"
mkdir "$work/stage"
cp /bin/true "$work/stage/a program"
printf '#!/bin/sh\n' >"$work/stage/script" && chmod +x "$work/stage/script"
only_program() { [ "$(bundle_binaries "$work/stage" | tr '\0' '|')" = "$work/stage/a program|" ]; }
expect "the binaries of a folder are its programs, also with a space in the name, without scripts" only_program
expect "the package of a library is found" [ "$(bundle_owner "$(realpath /lib/x86_64-linux-gnu/libc.so.6)")" = libc6 ]
exit "$failed"
