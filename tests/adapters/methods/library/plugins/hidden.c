// SPDX-License-Identifier: BSD-3-Clause
/* Without SLALOM_METHOD_EXPORT of the header, hidden visibility hides the function. */
const void* slalom_method_get_api(void);

const void* slalom_method_get_api(void) {
  return 0;
}
