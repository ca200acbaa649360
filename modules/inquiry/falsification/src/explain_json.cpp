// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/falsification/explain.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using OrderedJson = nlohmann::ordered_json;

ExaminedFailure examined_failure(const OrderedJson& json) {
  ExaminedFailure failure;
  json.at("found").get_to(failure.found);
  json.at("command").get_to(failure.command);
  json.at("smallest").get_to(failure.smallest);
  json.at("compared").get_to(failure.compared);
  json.at("neighbors").get_to(failure.neighbors);
  json.at("obstacles").get_to(failure.obstacles);
  json.at("bottleneck_robot_widths").get_to(failure.bottleneck_width);
  json.at("independent").get_to(failure.independent);
  return failure;
}

}  // namespace

std::string to_json(const ExaminedFailures& examined) {
  OrderedJson json = {{"method", examined.method}, {"repetition", examined.repetition}};
  json["failures"] = OrderedJson::array();
  for (const ExaminedFailure& failure : examined.failures)
    json["failures"].push_back({{"found", failure.found},
                                {"command", failure.command},
                                {"smallest", failure.smallest},
                                {"compared", failure.compared},
                                {"neighbors", failure.neighbors},
                                {"obstacles", failure.obstacles},
                                {"bottleneck_robot_widths", failure.bottleneck_width},
                                {"independent", failure.independent}});
  return json.dump(2) + "\n";
}

ExaminedFailures examined_failures_from_json(const std::string& text, const std::string& where) {
  ExaminedFailures examined;
  try {
    const OrderedJson json = OrderedJson::parse(text);
    json.at("method").get_to(examined.method);
    json.at("repetition").get_to(examined.repetition);
    for (const OrderedJson& failure : json.at("failures"))
      examined.failures.push_back(examined_failure(failure));
  } catch (const nlohmann::json::exception& error) {
    throw file_error(where, error.what(), "what slalom-falsify has written");
  }
  return examined;
}

}  // namespace slalom
