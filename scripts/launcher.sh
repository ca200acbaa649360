#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Starts the program of its name of the archive, on systems whose glibc is older than @GLIBC@ with the one of the archive.
prefix=$(dirname "$(dirname "$(readlink -f "$0")")")
program=$prefix/lib/slalom/programs/$(basename "$0") glibc=$prefix/lib/slalom/glibc
have=$(getconf GNU_LIBC_VERSION 2>/dev/null) own=@MINOR@
minor=${have#glibc 2.}
[ "$have" = "$minor" ] || [ "${minor%%.*}" -lt "$own" ] || exec "$program" "$@"
exec "$glibc/ld-linux-x86-64.so.2" --library-path "$glibc" "$program" "$@"
