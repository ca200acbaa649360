# SPDX-License-Identifier: BSD-3-Clause
def command():
    return 0.125, 0.5


def fail():
    raise KeyError("no such\nplan")
