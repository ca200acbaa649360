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
  const auto error = estimate.value.standard_error();
  return start + cell(short_number(estimate.value.number()) + unit, 14) +
         cell(error ? short_number(*error) + unit : "-", 16) + std::to_string(estimate.samples) +
         "\n";
}

std::string ini_line(const Estimate& estimate) {
  if (estimate.value.is_na())
    return "# " + estimate.id + ": " + format_value(estimate.value) + "\n";
  return estimate.id + " = " + short_number(estimate.value.number()) + "\n";
}

}  // namespace

std::string render_text(const Identification& identification) {
  std::string text =
      identification.log + "\nquantity       estimate      standard error  samples\n";
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
                                 {"estimates", nlohmann::ordered_json::object()},
                                 {"warnings", identification.warnings}};
  for (const Estimate& estimate : identification.estimates) {
    auto& entry = json["estimates"][estimate.id];
    if (estimate.value.is_na()) {
      entry = {{"na", estimate.value.reason()}};
      continue;
    }
    const auto error = estimate.value.standard_error();
    entry = {{"value", estimate.value.number()},
             {"standard_error", error ? nlohmann::ordered_json(*error) : nullptr},
             {"unit", estimate.unit},
             {"samples", estimate.samples}};
  }
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace slalom
