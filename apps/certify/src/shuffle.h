// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/random.h>

#include <utility>
#include <vector>

namespace slalom {

/// Puts the elements in random order.
template <typename T>
void shuffle(std::vector<T>& elements, RandomEngine& engine) {
  const int last = static_cast<int>(elements.size()) - 1;
  for (int i = 0; i < last; ++i)
    std::swap(elements[static_cast<std::size_t>(i)],
              elements[static_cast<std::size_t>(uniform_int(engine, i, last))]);
}

}  // namespace slalom
