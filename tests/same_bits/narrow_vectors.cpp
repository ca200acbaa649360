// SPDX-License-Identifier: BSD-3-Clause
// Preloaded: Highway uses only the vectors that each processor of this architecture has.
#include <hwy/targets.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

const bool narrowed = [] {
  hwy::DisableTargets(~static_cast<std::int64_t>(HWY_STATIC_TARGET));
  if (hwy::SupportedTargets() == HWY_STATIC_TARGET) return true;
  std::fputs("narrow_vectors: Highway still uses other vectors\n", stderr);
  std::abort();
}();

}  // namespace
