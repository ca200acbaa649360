#include "fuzz_target.h"

#include <slalom/scenario/selection.h>

/// Expressions that choose scenarios, and the order that they come in.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const std::string text = fuzz::text_of(data, size);
  const SelectionVocabulary words{
      {"density", "clearness"}, {"name", "tag", "id"}, {{"by_density", 3}}};
  fuzz::read_or_refuse([&] { number_fields(parse_selection(text, words), words); });
  fuzz::read_or_refuse([&] { parse_selection_order(text, words); });
  return 0;
}
