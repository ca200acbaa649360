// SPDX-License-Identifier: BSD-3-Clause
// in_private_network COMMAND ARGUMENTS...: runs a test in its own network namespace (if not
// permitted, in that of the machine).
#include "private_network.h"

#include <cstdio>
#include <unistd.h>

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  slalom::enter_private_network();
  if (!slalom::has_multicast()) {
    std::fputs("Skipped: neither a private network nor one with multicast\n", stderr);
    return 77;
  }
  execvp(argv[1], argv + 1);
  std::perror(argv[1]);
  return 127;
}
