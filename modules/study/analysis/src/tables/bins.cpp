// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/bins.h>
#include <slalom/analysis/cell.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr long long kMaxBins = 1000;
constexpr const char* kForms =
    "all, ID, ID:EDGE,EDGE,..., ID:COUNT, ID:qCOUNT or ID:@INDEX, such as density:0,0.1,0.2 or "
    "density:q4";

/// The text of a specification and where it is.
struct Source {
  std::string where, text;

  Error error(const std::string& what) const {
    return usage_error(where + " '" + text + "'", what, kForms);
  }
};

int parse_count(const Source& spec, const std::string& text) {
  long long count = 0;
  if (!parse_integer(text, count) || count < 1 || count > kMaxBins) {
    throw spec.error("invalid number of bins '" + text + "' (1 to 1000)");
  }
  return static_cast<int>(count);
}

std::vector<double> parse_edges(const Source& spec, const std::string& text) {
  std::vector<double> edges;
  for (const std::string& part : split(text, ',')) {
    double edge = 0;
    if (!parse_number(part, edge) || !std::isfinite(edge)) {
      throw spec.error("invalid number '" + part + "'");
    }
    if (!edges.empty() && edge <= edges.back()) throw spec.error("edges are not increasing");
    edges.push_back(edge);
  }
  return edges;
}

Error unknown_rows(const std::string& id, const ResultTable& table) {
  std::vector<std::string> names;
  for (const ValueColumn& column : table.descriptors) names.push_back(column.info().id);
  for (const ValueColumn& column : table.metrics) names.push_back(column.info().id);
  return usage_error("rows", "no descriptor '" + id + "' in these results",
                     expected_name(id, names));
}

std::vector<double> sorted_values(const ValueColumn& column) {
  std::vector<double> values;
  values.reserve(column.size());
  for (std::size_t row = 0; row < column.size(); ++row) {
    if (!column.is_na(row)) values.push_back(column.number(row));
  }
  std::sort(values.begin(), values.end());
  return values;
}

/// A multiple of 10^exponent, without the rounding error of a product with 0.1.
double decimal(double multiple, int exponent) {
  const double scale = math::pow(10.0, std::abs(exponent));
  return exponent < 0 ? multiple / scale : multiple * scale;
}

/// The power of ten that is between a hundredth and a thousandth of the edges' range.
int rounding_exponent(const std::vector<double>& edges) {
  const double largest = std::max(std::abs(edges.front()), std::abs(edges.back()));
  const double range = std::max({edges.back() - edges.front(), 1e-9 * largest, 1e-12});
  return static_cast<int>(std::floor(std::log10(std::min(range, 1e300)))) - 2;
}

/// `edges` rounded to three digits of their range, outwards at the ends, equal ones merged.
std::vector<double> rounded(const std::vector<double>& edges) {
  const int exponent = rounding_exponent(edges);
  const double steps = decimal(1, -exponent);
  double first = std::floor(edges.front() * steps), last = std::ceil(edges.back() * steps);
  // The products are rounded too: ensure that no value is outside.
  while (decimal(first, exponent) > edges.front()) --first;
  while (decimal(last, exponent) < edges.back()) ++last;
  if (last == first) ++last;
  std::vector<double> result = {decimal(first, exponent)};
  for (std::size_t i = 1; i + 1 < edges.size(); ++i) {
    const double multiple = std::round(edges[i] * steps);
    const double edge = decimal(multiple, exponent);
    if (edge > result.back() && multiple < last) result.push_back(edge);
  }
  result.push_back(decimal(last, exponent));
  return result;
}

std::vector<double> counted_edges(const BinSpec& spec, const std::vector<double>& values) {
  std::vector<double> edges;
  const double last = static_cast<double>(values.size() - 1);
  for (int i = 0; i <= spec.count; ++i) {
    const double fraction = static_cast<double>(i) / spec.count;
    if (spec.kind == BinSpec::Kind::EqualWidth) {
      edges.push_back(values.front() + fraction * (values.back() - values.front()));
    } else {
      const double position = fraction * last;
      const auto below = static_cast<std::size_t>(position);
      const std::size_t above = std::min(below + 1, values.size() - 1);
      edges.push_back(values[below] +
                      (position - static_cast<double>(below)) * (values[above] - values[below]));
    }
  }
  return rounded(edges);
}

}  // namespace

BinSpec parse_bin_spec(const std::string& text, const std::string& where) {
  const Source source = {where, text};
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() == 1 && parts[0] == "all") return {};
  if (parts.size() == 1 && text.find_first_of(",@ ") != std::string::npos)
    throw source.error("no bins");
  if (parts.size() == 1 && !parts[0].empty()) return parse_bin_spec(text + ":q4", where);
  if (parts.size() != 2 || parts[0].empty() || parts[1].empty()) {
    throw source.error("malformed");
  }
  BinSpec spec;
  spec.descriptor = parts[0];
  if (parts[1].front() == '@') {
    spec.kind = BinSpec::Kind::Index;
    spec.index = parts[1].substr(1);
    if (spec.index.empty()) throw source.error("missing name of the index");
  } else if (parts[1].find(',') != std::string::npos) {
    spec.kind = BinSpec::Kind::Edges;
    spec.edges = parse_edges(source, parts[1]);
  } else if (parts[1].front() == 'q') {
    spec.kind = BinSpec::Kind::Quantiles;
    spec.count = parse_count(source, parts[1].substr(1));
  } else {
    spec.kind = BinSpec::Kind::EqualWidth;
    spec.count = parse_count(source, parts[1]);
  }
  return spec;
}

std::vector<BinSpec> parse_bin_specs(const std::string& text, const std::string& where) {
  std::vector<BinSpec> specs;
  for (const std::string& part : split(text, ';')) {
    if (!part.empty()) specs.push_back(parse_bin_spec(part, where));
  }
  if (specs.empty()) throw Source{where, text}.error("no bins specified");
  return specs;
}

bool Bin::contains(double value) const {
  if (low && value < *low) return false;
  return !high || value < *high || (closed && value == *high);
}

std::string Bin::label() const {
  if (!low && !high) return "all";
  const bool is_value = closed && *high - *low <= 1e-8 * std::max(std::abs(*low), 1e-3);
  if (is_value) return format_number(*low);  // all values are equal
  return "[" + format_number(*low) + ", " + format_number(*high) + (closed ? "]" : ")");
}

RunValues::RunValues(const ResultTable& table, const std::string& id)
    : values_(find_descriptor(table, id)), scenario_(&table.scenario) {
  if (values_ != nullptr) return;
  values_ = find_unconditional(table, id);
  scenario_ = nullptr;
  if (values_ != nullptr) return;
  require_readable(table, "rows", id);
  throw unknown_rows(id, table);
}

std::vector<Bin> make_bins(const BinSpec& spec, const ResultTable& table) {
  if (spec.kind == BinSpec::Kind::All) return {Bin{}};
  const RunValues values(table, spec.descriptor);
  std::vector<double> edges = spec.edges;
  if (spec.kind == BinSpec::Kind::Index) {
    throw usage_error("rows '" + spec.descriptor + ":@" + spec.index + "'", "index not available",
                      "a scenario list with this index");
  }
  if (spec.kind != BinSpec::Kind::Edges) {
    const std::vector<double> sorted = sorted_values(values.column());
    if (sorted.empty()) return {};
    edges = counted_edges(spec, sorted);
  }
  std::vector<Bin> bins;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    bins.push_back({edges[i], edges[i + 1], i + 2 == edges.size()});
  }
  return bins;
}

}  // namespace slalom
