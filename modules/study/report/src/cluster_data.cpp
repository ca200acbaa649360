// SPDX-License-Identifier: BSD-3-Clause
#include "report_data.h"

#include <slalom/analysis/cell_json.h>
#include <slalom/analysis/cell_text.h>

namespace slalom {
namespace {

OrderedJson contrast_json(const Contrast& contrast) {
  return {{"id", contrast.quantity.id},
          {"name", contrast.quantity.name},
          {"unit", contrast.quantity.unit},
          {"pairs", contrast.pairs},
          {"higher", contrast.higher},
          {"lower", contrast.lower},
          {"failures", interval_json(contrast.group)},
          {"neighbors", interval_json(contrast.reference)},
          {"difference", contrast.difference.estimate},
          {"interval", interval_json(contrast.difference.interval)},
          {"p", contrast.p},
          {"adjusted_p", contrast.adjusted_p},
          {"p_text", p_number_text(contrast.adjusted_p)},
          {"holds", contrast.holds}};
}

OrderedJson contrasts_json(const std::vector<Contrast>& contrasts) {
  OrderedJson json = OrderedJson::array();
  for (const Contrast& contrast : contrasts) json.push_back(contrast_json(contrast));
  return json;
}

OrderedJson members_json(const std::vector<ReportedFailure>& members) {
  OrderedJson json = OrderedJson::array();
  for (const ReportedFailure& member : members)
    json.push_back({{"run", member.run},
                    {"found", member.found},
                    {"command", member.command},
                    {"departure", member.departure},
                    {"compared", member.compared},
                    {"neighbors", member.neighbors}});
  return json;
}

}  // namespace

OrderedJson clusters_json(const std::vector<ReportedCluster>& clusters) {
  OrderedJson json = OrderedJson::array();
  for (const ReportedCluster& cluster : clusters)
    json.push_back({{"name", cluster.name},
                    {"statements", cluster.statements},
                    {"basis", cluster.basis},
                    {"scenarios", contrasts_json(cluster.scenarios)},
                    {"runs", contrasts_json(cluster.runs)},
                    {"members", members_json(cluster.members)}});
  return json;
}

}  // namespace slalom
