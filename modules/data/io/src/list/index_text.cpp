// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/io/index_text.h>

#include <nlohmann/json.hpp>

namespace slalom {

std::string render_text(const ListIndex& index, const ListIndexCounts& counts) {
  std::string text = index.name + ": " + index.descriptor + "\n";
  for (std::size_t i = 0; i < index.ranges(); ++i)
    text += "  " + index.name + "[" + std::to_string(i) + "]  [" + format_number(index.edges[i]) +
            ", " + format_number(index.edges[i + 1]) + (i + 1 == index.ranges() ? "]" : ")") +
            "  " + std::to_string(counts.ranges[i]) + "\n";
  const std::pair<const char*, std::size_t> others[] = {{"below", counts.below},
                                                        {"above", counts.above},
                                                        {"NA", counts.na},
                                                        {"not computed", counts.unknown}};
  for (const auto& [name, count] : others)
    if (count > 0) text += std::string("  ") + name + "  " + std::to_string(count) + "\n";
  return text;
}

std::string render_json(const ListIndex& index, const std::optional<ListIndexCounts>& counts) {
  nlohmann::ordered_json json = {
      {"name", index.name}, {"descriptor", index.descriptor}, {"edges", index.edges}};
  for (const ValueKey& key : index.keys) json["parameters"].push_back(key.parameters);
  if (counts) {
    json["counts"] = counts->ranges;
    json["below"] = counts->below;
    json["above"] = counts->above;
    json["na"] = counts->na;
    json["unknown"] = counts->unknown;
  }
  return json.dump();
}

}  // namespace slalom
