// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/standings.h>

#include <algorithm>
#include <map>
#include <set>

namespace slalom {
namespace {

using Group = std::set<std::size_t>;  ///< indexes into the standings

/// Leaves out the groups that are part of another one, and one of equal groups.
void absorb(std::vector<Group>& groups) {
  std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return a.size() != b.size() ? a.size() > b.size() : a < b;
  });
  std::vector<Group> kept;
  for (const Group& group : groups) {
    const bool is_part = std::any_of(kept.begin(), kept.end(), [&](const Group& other) {
      return std::includes(other.begin(), other.end(), group.begin(), group.end());
    });
    if (!is_part) kept.push_back(group);
  }
  groups = std::move(kept);
}

/// Splits the groups that contain both methods.
void separate(std::size_t one, std::size_t other, std::vector<Group>& groups) {
  std::vector<Group> split;
  for (const Group& group : groups) {
    if (group.count(one) == 0 || group.count(other) == 0) {
      split.push_back(group);
      continue;
    }
    for (const std::size_t left_out : {one, other}) {
      split.push_back(group);
      split.back().erase(left_out);
    }
  }
  groups = std::move(split);
  absorb(groups);
}

}  // namespace

std::string Standing::letters() const {
  constexpr std::size_t kLetters = 26;
  std::string text;
  for (const std::size_t group : groups) {
    text += static_cast<char>('a' + group % kLetters);
    if (group >= kLetters) text += std::to_string(group / kLetters);
  }
  return text;
}

bool counts_runs(const ResultTable& table) {
  const ValueColumn* success = find_metric(table, "success");
  return success == nullptr || success->info().is_rate();
}

const PairedComparison* success_comparison(const std::vector<PairedComparison>& family,
                                           const std::string& one, const std::string& other) {
  for (const PairedComparison& c : family) {
    const bool is_pair = (c.a == one && c.b == other) || (c.a == other && c.b == one);
    if (is_pair && c.column.info.id == success_info().id) return &c;
  }
  return nullptr;
}

std::vector<Standing> build_standings(const ResultTable& table,
                                      const std::vector<PairedComparison>& family,
                                      const AnalysisOptions& options) {
  std::vector<Standing> standings;
  if (find_metric(table, success_info().id) == nullptr) return standings;
  for (MethodSummary& method : build_summary(table, {success_info().id}, options).methods)
    if (method.cells[0].estimate) standings.push_back({std::move(method)});
  std::stable_sort(standings.begin(), standings.end(), [](const Standing& a, const Standing& b) {
    return *a.method.cells[0].estimate > *b.method.cells[0].estimate;
  });
  const std::size_t n = standings.size();
  std::vector<Group> groups(1);
  for (std::size_t i = 0; i < n; ++i) groups[0].insert(i);
  for (Standing& standing : standings) standing.worst = n;
  std::map<std::string, std::size_t> row_of;
  for (std::size_t i = 0; i < n; ++i) row_of[standings[i].method.method] = i;
  for (const PairedComparison& c : family) {
    const auto a = row_of.find(c.a), b = row_of.find(c.b);
    const bool decided = c.verdict == Verdict::Better || c.verdict == Verdict::Worse;
    if (c.column.info.id != success_info().id || !decided || a == row_of.end() || b == row_of.end())
      continue;
    const bool b_wins = c.verdict == Verdict::Better;
    --standings[b_wins ? b->second : a->second].worst;
    ++standings[b_wins ? a->second : b->second].best;
    separate(a->second, b->second, groups);
  }
  std::sort(groups.begin(), groups.end());  // by their first methods
  for (std::size_t group = 0; group < groups.size(); ++group)
    for (const std::size_t i : groups[group]) standings[i].groups.push_back(group);
  return standings;
}

}  // namespace slalom
