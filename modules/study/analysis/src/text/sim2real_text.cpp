// SPDX-License-Identifier: BSD-3-Clause
#include "text_grid.h"

#include <slalom/analysis/cell_json.h>
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/sim2real.h>
#include <slalom/core/text.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

constexpr int kDigits = 3;

std::string interval_text(const Agreement& agreement) {
  if (!agreement.value) return "NA (" + agreement.reason + ")";
  return estimate_text(*agreement.value, agreement.interval, kDigits);
}

std::string order_text(const UndecidedOrder& order) {
  const std::string pair = order.better + " before " + order.worse + ": ";
  if (!order.more_runs) return pair + "their real means are equal\n";
  if (*order.more_runs == 0) return pair + "enough real runs\n";
  return pair + "about " + std::to_string(*order.more_runs) + " more real runs of each\n";
}

std::string ceiling_text(const Agreement& agreement) {
  if (!agreement.ceiling) return "";
  return estimate_text(agreement.ceiling->mean, agreement.ceiling->interval, kDigits);
}

nlohmann::ordered_json agreement_json(const Agreement& agreement) {
  nlohmann::ordered_json json = {{"value", number_or_null(agreement.value)},
                                 {"interval", interval_json(agreement.interval)}};
  if (agreement.ceiling)
    json["noise_ceiling"] = {{"value", agreement.ceiling->mean},
                             {"interval", interval_json(agreement.ceiling->interval)}};
  if (!agreement.reason.empty()) json["reason"] = agreement.reason;
  return json;
}

}  // namespace

std::string render_text(const Sim2Real& comparison) {
  const std::string unit = comparison.unit == "-" ? "" : ", " + comparison.unit;
  const std::string runs =
      comparison.scenarios == 0 ? "all runs" : count_text(comparison.scenarios, "common scenario");
  std::string text = comparison.metric + unit + ", " + runs + "\n\n";
  TextGrid methods({"method", "real", "n", "simulated", "n"});
  methods.align_right();
  for (const Sim2RealMethod& method : comparison.methods)
    methods.add_row({{method.name},
                     {format_fixed(method.real, kDigits)},
                     {std::to_string(method.real_runs)},
                     {format_fixed(method.simulated, kDigits)},
                     {std::to_string(method.simulated_runs)}});
  text += methods.text() + "\n";
  TextGrid figures(
      {"agreement", format_number(100 * comparison.confidence) + " % interval", "noise ceiling"});
  figures.add_row({{"Spearman's rho"},
                   {interval_text(comparison.spearman)},
                   {ceiling_text(comparison.spearman)}});
  figures.add_row({{"Kendall's tau-b"},
                   {interval_text(comparison.kendall)},
                   {ceiling_text(comparison.kendall)}});
  figures.add_row({{"Pearson's r"}, {interval_text(comparison.pearson)}, {}});
  figures.add_row({{"mean maximum rank violation" + unit}, {interval_text(comparison.mmrv)}, {}});
  text += figures.text() + "\nTo decide the real order, with " +
          format_number(100 * comparison.power) + " % power if the differences are as seen:\n";
  for (const UndecidedOrder& order : comparison.orders) text += "  " + order_text(order);
  return text;
}

nlohmann::ordered_json sim2real_json(const Sim2Real& comparison) {
  nlohmann::ordered_json json = {{"metric", comparison.metric},
                                 {"unit", comparison.unit},
                                 {"scenarios", comparison.scenarios},
                                 {"confidence", comparison.confidence},
                                 {"power", comparison.power},
                                 {"methods", nlohmann::ordered_json::array()},
                                 {"spearman", agreement_json(comparison.spearman)},
                                 {"kendall", agreement_json(comparison.kendall)},
                                 {"pearson", agreement_json(comparison.pearson)},
                                 {"mmrv", agreement_json(comparison.mmrv)},
                                 {"orders", nlohmann::ordered_json::array()}};
  for (const Sim2RealMethod& method : comparison.methods)
    json["methods"].push_back({{"name", method.name},
                               {"real", method.real},
                               {"real_runs", method.real_runs},
                               {"simulated", method.simulated},
                               {"simulated_runs", method.simulated_runs}});
  for (const UndecidedOrder& order : comparison.orders)
    json["orders"].push_back({{"better", order.better}, {"worse", order.worse}});
  for (std::size_t i = 0; i < comparison.orders.size(); ++i)
    json["orders"][i]["more_runs"] = comparison.orders[i].more_runs
                                         ? nlohmann::ordered_json(*comparison.orders[i].more_runs)
                                         : nlohmann::ordered_json(nullptr);
  return json;
}

}  // namespace slalom
