// SPDX-License-Identifier: BSD-3-Clause
#include "value_data.h"

#include <slalom/analysis/cell_json.h>

namespace slalom {
namespace {

constexpr int kBins = 4;

OrderedJson bins_json(const ResultTable& runs, const std::string& id) {
  BinSpec spec;
  spec.kind = BinSpec::Kind::Quantiles;
  spec.descriptor = id;
  spec.count = kBins;
  OrderedJson json = OrderedJson::array();
  for (const Bin& bin : make_bins(spec, runs))
    json.push_back({{"bin", bin.label()},
                    {"low", number_or_null(bin.low)},
                    {"high", number_or_null(bin.high)},
                    {"high_included", bin.closed}});
  return json;
}

}  // namespace

OrderedJson value_json(const ValueColumn& metric, std::size_t run, Names& reasons) {
  if (metric.is_na(run)) return OrderedJson::array({reasons.index(metric.reason(run))});
  return rounded_json(metric.number(run));
}

OrderedJson value_data(const ResultTable& runs) {
  OrderedJson values = OrderedJson::array(), bins = OrderedJson::object();
  Names reasons;
  for (const ValueColumn* metric : repeatable_metrics(runs)) {
    OrderedJson column = OrderedJson::array();
    for (std::size_t run = 0; run < runs.size(); ++run)
      column.push_back(value_json(*metric, run, reasons));
    values.push_back(std::move(column));
    bins[metric->info().id] = bins_json(runs, metric->info().id);
  }
  for (const ValueColumn& descriptor : runs.descriptors)
    bins[descriptor.info().id] = bins_json(runs, descriptor.info().id);
  return {{"values", values}, {"reasons", reasons.all()}, {"bins", bins}};
}

}  // namespace slalom
