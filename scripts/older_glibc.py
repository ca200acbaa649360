#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lets a library load with a glibc that is older than one of its functions: scripts/older_glibc.py FILE FUNCTION
The function is then looked up in all libraries, without its version; FILE no longer requires that version. FILE is an ELF
file for 64 bits whose only function of this version is FUNCTION, and needs another library that has it. Of bundle.sh."""
import struct
import sys

HEADER, SECTION, SYMBOL, NEED, VERSION = "<16xHHIQQQIHHHHHH", "<IIQQQQIIQQ", "<IBBHQQ", "<HHIII", "<IHHII"
DYNSYM, VERSYM, VERNEED = 11, 0x6FFFFFFF, 0x6FFFFFFE  # types of sections
UNVERSIONED = 1


def sections(data: bytearray) -> list:
    head = struct.unpack_from(HEADER, data)
    return [struct.unpack_from(SECTION, data, head[5] + i * head[10]) for i in range(head[11])]


def text(data: bytearray, table: tuple, offset: int) -> str:
    start = table[4] + offset
    return data[start : data.index(0, start)].decode()


def release(data: bytearray, function: str) -> str:
    """Removes the version of a function; the version's name."""
    table = sections(data)
    symbols, versions, needs = (next(s for s in table if s[1] == kind) for kind in (DYNSYM, VERSYM, VERNEED))
    users: dict[int, list] = {}
    for i in range(symbols[5] // symbols[9]):
        name, _, _, section, _, _ = struct.unpack_from(SYMBOL, data, symbols[4] + i * symbols[9])
        index = struct.unpack_from("<H", data, versions[4] + 2 * i)[0]
        if section == 0 and index > UNVERSIONED:
            users.setdefault(index, []).append((text(data, table[symbols[6]], name), i))
    index = next((k for k, v in users.items() if any(name == function for name, _ in v)), None)
    if index is None:
        raise ValueError(f"no undefined function {function} with a version")
    if len(users[index]) > 1:
        raise ValueError(f"more functions of the version of {function}: {', '.join(name for name, _ in users[index])}")
    need = needs[4]
    while True:  # for each library: its versions, one of which takes the place of the removed one
        _, count, _, first, next_need = struct.unpack_from(NEED, data, need)
        entries, at = [], need + first
        for _ in range(count):
            entries.append((at, struct.unpack_from(VERSION, data, at)))
            at += entries[-1][1][4]
        removed = next(((place, entry) for place, entry in entries if entry[2] == index), None)
        other = next((entry for _, entry in entries if entry[2] != index), None)
        if removed and other:
            place, entry = removed
            struct.pack_into(VERSION, data, place, other[0], other[1], entry[2], other[3], entry[4])
            struct.pack_into("<H", data, versions[4] + 2 * users[index][0][1], UNVERSIONED)
            return text(data, table[needs[6]], entry[3])
        if next_need == 0:
            raise ValueError(f"no other version beside that of {function}")
        need += next_need


def main(path: str, function: str) -> None:
    with open(path, "rb") as file:
        data = bytearray(file.read())
    if data[:6] != b"\x7fELF\x02\x01":
        sys.exit(f"older_glibc.py: {path}: expected an ELF file for 64 bits")
    try:
        version = release(data, function)
    except ValueError as error:
        sys.exit(f"older_glibc.py: {path}: {error}")
    with open(path, "wb") as file:
        file.write(data)
    print(f"{path}: no longer needs {version} for {function}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
