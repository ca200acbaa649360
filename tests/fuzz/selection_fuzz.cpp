// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/scenario/selection.h>

/// Selection expressions and orders.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const std::string text = fuzz::text_of(data, size);
  const SelectionVocabulary vocabulary{{"density", "clearness"},
                                       {"name", "tag", "id"},
                                       {{"by_density", 3}},
                                       {{"mean clearance", "clearness"}, {"a, b", "density"}}};
  fuzz::read_or_refuse([&] { number_fields(parse_selection(text, vocabulary), vocabulary); });
  fuzz::read_or_refuse([&] { parse_selection_order(text, vocabulary); });
  return 0;
}
