# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Functions of archive.sh and wheel.sh, which source this file: an installation that runs on other Linux distributions.
bundle_refuse() {
  echo "$(basename "$0"): $1" >&2
  exit 2
}

# Fails unless the finished release build and the tools are there.
bundle_require() {
  local tool
  for tool in dpkg patchelf objdump "$@"; do
    command -v "$tool" >/dev/null || bundle_refuse "needs the package $tool"
  done
  [ -x build/release/bin/slalom-evaluate ] ||
    bundle_refuse "build/release: no programs; expected the build of scripts/build.sh release packaged"
  [ "$(uname -m)" = x86_64 ] || bundle_refuse "$(uname -m): expected a computer with x86_64"
}

bundle_version() { sed -n 's/^project(slalom VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt; }

# Files of programs and libraries below a folder.
bundle_binaries() {
  find "$1" -type f \( -perm -100 -o -name '*.so*' \) -print0 | while IFS= read -r -d '' file; do
    [ "$(head -c 4 "$file" | tr -d '\0')" = $'\x7fELF' ] && printf '%s\0' "$file"
  done
}

# The Debian package of a file, which its database has with or without /usr.
bundle_owner() { { dpkg -S "$1" || dpkg -S "${1#/usr}" || dpkg -S "/usr$1"; } 2>/dev/null | head -1 | cut -d: -f1; }

# Python's standard library and NumPy below STAGE/lib/slalom/python, where the programs find them.
bundle_python() {
  local stage=$1 version home
  version=$(/usr/bin/python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')
  home=$stage/lib/slalom/python/lib
  mkdir -p "$home/python$version" "$home/python3/dist-packages"
  tar -C "/usr/lib/python$version" --exclude=__pycache__ --exclude='./config-*' --exclude=./dist-packages \
    --exclude=./sitecustomize.py --exclude=./idlelib --exclude=./tkinter --exclude=./ensurepip --exclude=./lib2to3 \
    --exclude=./pydoc_data --exclude=./test --exclude='./lib-dynload/nis.*' -c . | tar -C "$home/python$version" -x
  tar -C /usr/lib/python3/dist-packages --exclude=__pycache__ --exclude=tests --exclude='*.a' --exclude='*.h' \
    -c numpy | tar -C "$home/python3/dist-packages" -x
  printf '%s\n' "libpython$version-stdlib" "libpython$version-minimal" python3-numpy
}

# The C header of methods below STAGE/include and the CMake package with it, without the libraries of Slalom.
bundle_method_interface() {
  local stage=$1 all
  all=$(mktemp -d)
  cmake --install build/release --prefix "$all" --component development >/dev/null
  (cd "$all" && find . -path ./include/slalom/methods/slalom_method.h -o -path ./include/slalom/slalom.h -o -path '*/cmake/slalom/slalomConfig*.cmake' \
    -o -path '*/cmake/slalom/slalomTargets*.cmake' -o -path '*/cmake/slalom/SlalomMethod.cmake') |
    tar -C "$all" -T - -c | tar -C "$stage" -x
  rm -rf "$all"
}

# The oldest glibc, as the number after "2.", with which all programs and libraries below a folder load.
bundle_glibc() {
  bundle_binaries "$1" | xargs -0 objdump -T 2>/dev/null | grep -oP '\(GLIBC_2\.\K[0-9]+' | sort -nu | tail -1
}

# Lets the libraries in a folder load with glibc 2.35, as in Ubuntu 22.04: some use a function that 2.36 has brought.
bundle_older_glibc() {
  local file name=libslalom_arc4random.so.1
  cc -O2 -Wall -Werror -shared -fPIC -Wl,-soname,$name scripts/arc4random.c -o "$1/$name"
  for file in "$1"/*.so*; do
    objdump -T "$file" | grep 'GLIBC_2\.36) arc4random_buf$' >/dev/null || continue
    patchelf --add-needed $name "$file"
    scripts/older_glibc.py "$file" arc4random_buf >/dev/null
  done
}

# Installs the programs and the Python package in the empty folder STAGE with all libraries that they need. Left out are
# glibc, and the libraries of GCC, which drivers of graphics of newer systems need in their own version.
bundle_stage() {
  local stage=$1 bundled=$1/lib/slalom/bundled licenses=$1/share/doc/slalom/licenses component file name path package
  local of_system='^(linux-vdso|ld-linux.*|lib(c|m|pthread|dl|rt|resolv|util|nsl|anl|stdc\+\+|gcc_s)\.so.*)$'
  for component in programs python; do
    cmake --install build/release --prefix "$stage" --component $component --strip >/dev/null
  done
  bundle_method_interface "$stage"
  mkdir -p "$bundled" "$licenses"
  # It loads the library of its name that is bundled.
  mkdir "$stage/codecs" && mv "$stage"/lib*/slalom/runtime/libopencv_imgcodecs.so* "$stage/codecs"
  bundle_python "$stage" >"$stage/packages"
  echo mrpt-common >>"$stage/packages" # of the maps of the demo
  while IFS= read -r -d '' file; do
    ldd "$file" | awk -v file="$file" '/not found/ {print "!", file; next} $2 == "=>" {print $1, $3}'
  done < <(bundle_binaries "$stage") | sort -u >"$stage/libraries"
  grep '^!' "$stage/libraries" && bundle_refuse "libraries of these files are not found"
  while read -r name path; do
    [[ $name =~ $of_system ]] && continue
    cp -L "$path" "$bundled/$name"
    chmod 644 "$bundled/$name"
    path=$(realpath "$path")
    package=$(bundle_owner "$path")
    [ "$package" ] || bundle_refuse "$path: is of no Debian package; expected one, with its license"
    echo "$package" >>"$stage/packages"
  done <"$stage/libraries"
  bundle_older_glibc "$bundled"
  mv "$stage"/codecs/* "$stage/lib/slalom/runtime" && rmdir "$stage/codecs"
  while IFS= read -r -d '' file; do
    path="\$ORIGIN/$(realpath --relative-to="$(dirname "$file")" "$bundled")"
    [[ $file == "$bundled"/* ]] || path="\$ORIGIN/$(realpath --relative-to="$(dirname "$file")" "$stage/lib/slalom/runtime"):$path"
    patchelf --set-rpath "$path" "$file"
  done < <(bundle_binaries "$stage")
  sort -u "$stage/packages" | while read -r package; do
    cp -L "/usr/share/doc/$package/copyright" "$licenses/$package"
    # shellcheck disable=SC2016
    dpkg-query -W -f '${binary:Package} ${Version} of ${source:Package} ${source:Version}\n' "$package"
  done >"$licenses/PACKAGES"
  rm "$stage/packages" "$stage/libraries"
  find "$stage" -type d -exec chmod 755 {} +
}

# Puts launchers before the programs of STAGE, and the glibc with which they run on older systems beside them.
bundle_launchers() {
  local stage=$1 programs=$1/lib/slalom/programs glibc=$1/lib/slalom/glibc minor name program path package
  minor=$(getconf GNU_LIBC_VERSION) minor=${minor#glibc 2.}
  mkdir "$glibc" "$programs"
  for name in ld-linux-x86-64.so.2 lib{c,m}.so.6 lib{pthread.so.0,dl.so.2,rt.so.1,resolv.so.2,util.so.1,stdc++.so.6,gcc_s.so.1}; do
    path=/lib/x86_64-linux-gnu/$name
    cp -L "$path" "$glibc/$name"
    package=$(bundle_owner "$(realpath "$path")")
    cp -L "/usr/share/doc/$package/copyright" "$stage/share/doc/slalom/licenses/$package"
  done
  for program in "$stage"/bin/slalom-*; do
    mv "$program" "$programs"
    patchelf --set-rpath "\$ORIGIN/../runtime:\$ORIGIN/../bundled" "$programs/$(basename "$program")"
    sed "s/@GLIBC@/2.$minor/; s/@MINOR@/$minor/" scripts/launcher.sh >"$program"
    chmod 755 "$program"
  done
}

# A time for all files, so that the same build gives the same archive.
bundle_time() { git log -1 --format=%ct; }
