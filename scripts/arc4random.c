/* SPDX-License-Identifier: BSD-3-Clause
   arc4random_buf() for libraries in an archive that run with a glibc before 2.36; a newer one has
   its own. */
#include <stddef.h>
#include <stdlib.h>
#include <sys/random.h>

void arc4random_buf(void* buffer, size_t size) {
  for (char* next = buffer; size > 0;) {
    const ssize_t count = getrandom(next, size, 0);
    if (count < 0) continue; /* interrupted by a signal, the only error of a valid buffer */
    next += count;
    size -= (size_t)count;
  }
}
