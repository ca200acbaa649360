// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_command.h"

#include <slalom/core/error.h>
#include <slalom/core/random.h>
#include <slalom/core/text.h>

#include <cmath>

namespace slalom {

bool is_held_out(const std::string& hash, const SplitOptions& options) {
  const std::uint64_t random = derive_seed(options.seed, "held out " + hash);
  return std::ldexp(static_cast<double>(random >> 11U), -53) < options.held_out;
}

ListCommandPtr make_split(ScenarioList& source, SplitOptions options, ScenarioList& development,
                          ScenarioList& held_out) {
  if (!(options.held_out >= 0 && options.held_out <= 1))
    throw usage_error("held-out fraction", "invalid value " + format_number(options.held_out),
                      "0 to 1");
  return std::make_unique<RecordedCommand>(
      std::vector<ScenarioList*>{&development, &held_out}, "Split " + scenarios_text(source.size()),
      [&source, options, &development, &held_out] {
        source.for_each({}, [&](const ScenarioList::Entry& entry) {
          (is_held_out(entry.hash, options) ? held_out : development).copy_from(source, entry);
          return true;
        });
      });
}

}  // namespace slalom
