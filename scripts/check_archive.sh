#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Unpacks the archive of scripts/archive.sh in a new system below /tmp and uses it as an ordinary user:
#   scripts/check_archive.sh [SUITE [ARCHIVE [MIRROR]]]
# SUITE is the code name of a release of Debian, default trixie (Debian 13), or of Ubuntu, focal (20.04), jammy, noble or
# resolute (26.04). ARCHIVE is by default that of build/release, MIRROR that of the distribution; Ubuntu's signatures are
# checked only where its keyring is installed. The folder has a space in its name.
# Without any package installed there: the demo, the first campaign of the README with its report, a method in Python, a
# neural network, a process by LCM; the values of the demo are printed as a hash, which is that of all systems. Then, with a
# compiler, Python and Xvfb of that system: the methods of the tutorial and of examples/library_method in C++ and C,
# examples/c_interface, import slalom, and Slalom Studio. Nothing is left when the folder is removed.
# Environment variables: BUNDLES, a folder with bundles that are verified there, such as FOLDER/slalom-standard of
# scripts/baselines.sh FOLDER; FRACTION, the part of their scenarios (0.02).
# Runs as root; needs the packages debootstrap (for Debian, or mmdebstrap), iproute2, util-linux and zstd. Not part of
# scripts/test.sh, as it downloads a system.
# shellcheck disable=SC2016  # the commands of try and of expect_runs are expanded in the new system
set -euo pipefail
sources=$(dirname "$(dirname "$(realpath "$0")")")
source "$sources/scripts/chroot.sh"
[ "${1:-}" != --help ] || { usage && exit 0; }
suite=${1:-trixie} archive=${2:-$(compgen -G "$sources/build/release/slalom-*-x86_64.tar.zst" || true)} mirror=${3:-}
expect_suite "$suite"
[ -f "$archive" ] || refuse "${archive:-$sources/build/release}: no archive; expected that of scripts/archive.sh"
with_private_mounts "$suite" "$archive" "$mirror"

new_system "$suite" "$mirror"
inside useradd --create-home user
as_user() { chroot --userspec=user:user "$root" /usr/bin/env -i PATH=/usr/bin:/bin HOME=/home/user LC_ALL=C "$@"; }
home="$root/home/user"
start=$SECONDS
as_user mkdir "/home/user/my programs" /home/user/work
zstd -dcq "$archive" | as_user tar -C "/home/user/my programs" -x
echo "== unpacked in $(since $start): $(du -sm "$home/my programs" | cut -f1) MB"
# An older system than that of the archive runs its programs with the archive's own glibc.
glibc=$(inside getconf GNU_LIBC_VERSION)
[ "${glibc#glibc 2.}" -ge 35 ] && needs_own='' || needs_own='GLIBC\|GLIBCXX\|CXXABI'
echo "== $glibc"
missing=$(as_user sh -c 'find "/home/user/my programs" -type f \( -path "*/programs/*" -o -name "*.so*" \) ! -path "*/slalom/glibc/*" -exec ldd {} +' 2>&1 |
  grep 'not found' | { [ "$needs_own" ] && grep -v "version .\($needs_own\)_" || cat; } || true)
[ -z "$missing" ] || { echo "missing:"; sort -u <<<"$missing"; exit 1; }

# Runs commands of sh with the programs on PATH, and prints how long they took: try NAME [COMMANDS OF THE CALL...]
try() {
  local start=$SECONDS name=$1 commands
  commands=$(cat)
  "${@:2}" as_user sh -euc 'SLALOM=$(echo "/home/user/my programs"/slalom-*)
    PATH="$SLALOM/bin:$PATH"; cd /home/user/work; '"$commands"
  echo "== $name in $(since $start)"
}
# Succeeds if the 20 runs of a campaign are there and its method never failed.
expect_runs() { echo 'runs=$(slalom-analyze dump '"$1"'/runs.results); test "$(echo "$runs" | grep -c outcome)" -ge 20
  ! echo "$runs" | grep -q "\"method_[a-z]*\""'; }

try "the demo" <<<'slalom-evaluate --demo -j 2 --quiet >demo.txt; test -s slalom-demo/report/index.html
  slalom-analyze dump slalom-demo/runs.results | sha256sum'
readme_campaign "$sources" >"$home/work/my.ini"
# The method "mine" is the reader's own; one of the archive takes its place.
try "the first campaign of the README" <<<'slalom-evaluate my.ini -o out -j 2 --quiet \
    --set method.mine.plugin=libslalom_follow_the_gap.so
  test -s out/report/index.html; slalom-analyze summary out/runs.results; slalom-tune --help | head -3'
write_python_campaign "$home/work"
try "a report about a method in ten lines of Python" <<<'slalom-evaluate python.ini -o python -j 2 --quiet
  test -s python/report/index.html; slalom-analyze summary python/runs.results | grep " mine succeeds"'
cp "$sources"/examples/onnx_policy/policy.* "$home/work"
try "a neural network" <<<"slalom-evaluate policy.ini -o policy -j 2 --quiet >policy.txt; $(expect_runs policy)"
cat >"$home/work/lcm.ini" <<'CAMPAIGN'
[campaign]
methods = process
[scenarios]
generator = random
count = 20
[method.process]
adapter = lcm
launch = exec slalom-lcm-method --plugin libslalom_follow_the_gap.so
CAMPAIGN
# Multicast of LCM stays in a network of its own.
alone() { unshare --net bash -c 'ip link set lo up && ip route add 224.0.0.0/4 dev lo && "$@"' alone "$@"; }
export -f as_user && export root
try "a process by LCM" alone <<<"slalom-evaluate lcm.ini -o lcm -j 1 --quiet >lcm.txt; $(expect_runs lcm)"
if [ "${BUNDLES:-}" ]; then
  cp "$BUNDLES"/*.slalom "$home/work"
  try "bundles" <<<'for bundle in *.slalom
    do echo "$bundle: $(slalom-simulate verify "$bundle" --fraction '"${FRACTION:-0.02}"' -j 0 --quiet | tail -1)"; done'
fi

inside apt-get -qq update >/dev/null
inside apt-get -qq install -y --no-install-recommends cmake fonts-dejavu-core g++ libgl1-mesa-dri libglx-mesa0 make python3 python3-numpy \
  xauth xvfb >/dev/null
cp -r "$sources"/examples/{c_interface,library_method,tutorial} "$home/work" && inside chown -R user /home/user/work
try "the tutorial in C++ and Python" <<<"cd tutorial
  g++ -std=c++17 -O2 -shared -fPIC -I\"\$SLALOM/include\" my_method.cpp -o libmy_method.so
  slalom-scenarios generate -c scenarios.ini -o my.scenarios --quiet
  slalom-evaluate campaign.ini -o out -j 2 --quiet >out.txt; $(expect_runs out)"
try "a method in C, by CMake" <<<"cd library_method
  cmake -S . -B build -DCMAKE_PREFIX_PATH=\"\$SLALOM\" >/dev/null; cmake --build build >/dev/null
  slalom-evaluate campaign.ini -o out -j 2 --quiet >out.txt; $(expect_runs out)"
if [ "$needs_own" ]; then
  try "import slalom says what it needs" <<<'export PYTHONPATH="$SLALOM/lib/python3/dist-packages"
    ! python3 -c "import slalom; slalom.generate(\"random\", 1)" 2>error.txt; grep "expected glibc 2.35 or newer" error.txt'
else
  try "an evaluation in C, by CMake" <<<"cd c_interface
  cmake -S . -B build -DCMAKE_PREFIX_PATH=\"\$SLALOM\" >/dev/null; cmake --build build >/dev/null; ./build/my_evaluation"
cat >"$home/work/evaluate.py" <<'PROGRAM'
import hashlib, sys, slalom
class Turns:
    def step(self, o): return 0.4, 0.8 if o.goal_y > 0 else -0.8
gap = slalom.plugin("libslalom_follow_the_gap.so")
results = slalom.evaluate({"turns": Turns, "gap": gap}, slalom.generate("random", 20), workers=2, trajectories=True)
bits = b"".join(bytes(memoryview(one).cast("B")) for one in results.trajectories)
print("import slalom in Python", sys.version.split()[0], hashlib.sha256(bits).hexdigest())
print(results)
PROGRAM
try "import slalom in this system's Python" <<<'export PYTHONPATH="$SLALOM/lib/python3/dist-packages"
  python3 evaluate.py; python3 -S evaluate.py | head -1'
fi
try "Slalom Studio" <<<'printf "size 1280 800\nwait idle\nexpect list contains \"70 scenarios\"\nscreenshot studio.png\n" >studio.txt
  LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a slalom-studio slalom-demo/campaign.scenarios --script studio.txt; test -s studio.png'
as_user rm -r "/home/user/my programs"
left=$(as_user find /home/user -mindepth 1 -maxdepth 1 ! -name '.*' ! -name work)
[ -z "$left" ] || { echo "left behind:"; echo "$left"; exit 1; }
echo "== removed: nothing is left"
