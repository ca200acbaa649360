// SPDX-License-Identifier: BSD-3-Clause
#include "result_fixture.h"

#include <slalom/analysis/standings.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

namespace slalom {
namespace {

/// Methods "a", "b", ... whose rates fall, and the comparisons of all pairs: those in `shown` have
/// a verdict, of either direction of the pair.
struct Relation {
  ResultFixture fixture;
  std::vector<PairedComparison> family;

  explicit Relation(std::size_t methods,
                    const std::set<std::pair<std::size_t, std::size_t>>& shown) {
    for (std::size_t scenario = 0; scenario < methods; ++scenario) {
      const std::string hash = fixture.add_scenario(Value::of(0.5));
      for (std::size_t method = 0; method < methods; ++method)
        fixture.add_run(hash, name_of(method), scenario >= method ? 0.9 : -1);
    }
    for (std::size_t i = 0; i < methods; ++i)
      for (std::size_t j = i + 1; j < methods; ++j) {
        PairedComparison c;
        const bool turned = (i + j) % 2 == 0;
        c.a = name_of(turned ? j : i);
        c.b = name_of(turned ? i : j);
        c.column.info = success_info();
        c.verdict = shown.count({i, j}) == 0 ? Verdict::NotEnough
                    : turned                 ? Verdict::Better
                                             : Verdict::Worse;
        family.push_back(c);
      }
  }

  static std::string name_of(std::size_t method) { return std::string(1, 'a' + char(method)); }
  std::vector<Standing> standings() const { return build_standings(fixture.table, family, {}); }
};

TEST(Standings, OfADesignWithKnownLetters) {
  // a > c, d; b > d: a and b share a group, b and c, c and d.
  const auto found = Relation(4, {{0, 2}, {0, 3}, {1, 3}}).standings();
  ASSERT_EQ(found.size(), 4u);
  std::string letters, ranks;
  for (const Standing& one : found) {
    letters += one.letters() + " ";
    ranks += std::to_string(one.best) + "-" + std::to_string(one.worst) + " ";
  }
  EXPECT_EQ(letters, "a ab bc c ");
  EXPECT_EQ(ranks, "1-2 1-3 2-4 3-4 ");
}

RC_GTEST_PROP(Standings, TwoMethodsShareALetterExactlyIfNeitherIsBetter, ()) {
  const auto methods = *rc::gen::inRange<std::size_t>(1, 9);
  std::set<std::pair<std::size_t, std::size_t>> shown;
  for (std::size_t i = 0; i < methods; ++i)
    for (std::size_t j = i + 1; j < methods; ++j)
      if (*rc::gen::arbitrary<bool>()) shown.insert({i, j});
  const auto found = Relation(methods, shown).standings();
  RC_ASSERT(found.size() == methods);
  std::set<std::set<std::size_t>> groups;
  for (std::size_t i = 0; i < methods; ++i) {
    RC_ASSERT(found[i].method.method == Relation::name_of(i));
    std::size_t better = 0, worse = 0;
    for (std::size_t j = 0; j < methods; ++j) {
      better += shown.count({j, i});
      worse += shown.count({i, j});
      std::vector<std::size_t> common;
      std::set_intersection(found[i].groups.begin(), found[i].groups.end(), found[j].groups.begin(),
                            found[j].groups.end(), std::back_inserter(common));
      const bool differ = shown.count({i, j}) + shown.count({j, i}) > 0;
      RC_ASSERT(common.empty() == differ);
    }
    RC_ASSERT(found[i].best == 1 + better);
    RC_ASSERT(found[i].worst == methods - worse);
  }
  // No group is a part of another one.
  for (std::size_t group = 0; group < 64; ++group) {
    std::set<std::size_t> members;
    for (std::size_t i = 0; i < methods; ++i)
      if (std::count(found[i].groups.begin(), found[i].groups.end(), group) > 0) members.insert(i);
    if (members.empty()) continue;
    for (const auto& other : groups) {
      RC_ASSERT(!std::includes(other.begin(), other.end(), members.begin(), members.end()));
      RC_ASSERT(!std::includes(members.begin(), members.end(), other.begin(), other.end()));
    }
    groups.insert(members);
  }
}

TEST(Standings, LettersGoOnAfterTheAlphabet) {
  Standing standing;
  standing.groups = {0, 25, 26, 53};
  EXPECT_EQ(standing.letters(), "aza1b2");
}

}  // namespace
}  // namespace slalom
