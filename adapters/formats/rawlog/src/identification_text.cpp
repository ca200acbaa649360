// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/rawlog/identification.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace slalom {
namespace {

/// Five digits after the point: 0.01 ms, 0.01 mm.
std::string short_number(double number) {
  return format_number(std::round(1e5 * number) / 1e5);
}

std::string table_row(const Estimate& estimate) {
  const auto cell = [](std::string text, std::size_t width) {
    text.resize(std::max(width, text.size() + 1), ' ');
    return text;
  };
  const std::string start = cell(estimate.id, 15);
  if (estimate.value.is_na()) return start + format_value(estimate.value) + "\n";
  const std::string unit = estimate.unit == "-" ? "" : " " + estimate.unit;
  const auto& interval = estimate.interval;
  return start + cell(short_number(estimate.value.number()) + unit, 14) +
         cell(std::to_string(estimate.samples), 9) +
         (interval ? short_number(interval->low) + " to " + short_number(interval->high) + unit
                   : "NA (" + estimate.no_interval + ")") +
         "\n";
}

std::string ini_line(const Estimate& estimate) {
  if (estimate.value.is_na())
    return "# " + estimate.id + ": " + format_value(estimate.value) + "\n";
  return estimate.id + " = " + short_number(estimate.value.number()) + "\n";
}

}  // namespace

std::string render_text(const Identification& identification) {
  std::string text = identification.log + "\nquantity       estimate      samples  " +
                     format_number(100 * Identification::kConfidence) + " % interval\n";
  for (const Estimate& estimate : identification.estimates) text += table_row(estimate);
  for (const std::string& warning : identification.warnings) text += "Warning: " + warning + "\n";
  text += "\n[robot]\n# v_bias, w_bias: no keys; measured / commanded velocity\n";
  for (const char* id : {"delay", "delay_tau"}) text += ini_line(identification.at(id));
  text += "[sensor]\n";
  for (const char* id : {"noise_sigma", "dropout_ratio", "quantum"})
    text += ini_line(identification.at(id));
  return text;
}

std::string render_json(const Identification& identification) {
  nlohmann::ordered_json json = {{"log", identification.log},
                                 {"confidence", Identification::kConfidence},
                                 {"estimates", nlohmann::ordered_json::object()},
                                 {"warnings", identification.warnings}};
  for (const Estimate& estimate : identification.estimates) {
    auto& entry = json["estimates"][estimate.id];
    if (estimate.value.is_na()) {
      entry = {{"na", estimate.value.reason()}};
      continue;
    }
    entry = {
        {"value", estimate.value.number()}, {"unit", estimate.unit}, {"samples", estimate.samples}};
    if (estimate.interval)
      entry["interval"] = {estimate.interval->low, estimate.interval->high};
    else
      entry["no_interval"] = estimate.no_interval;
  }
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace slalom
