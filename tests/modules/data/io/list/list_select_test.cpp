// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "list_sample.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slalom {
namespace {

/// True, false, or none for a comparison with NA.
using Truth = std::optional<bool>;

/// An expression as text and its reference implementation without SQL.
struct Expression {
  std::string text;
  std::function<Truth(const SampleRow&)> holds;
};

Expression random_comparison(RandomEngine& engine) {
  const std::string fields[] = {"density", "clearness", "confinement"};
  const std::string field = fields[uniform_int(engine, 0, 2)];
  const double low = uniform_int(engine, 0, 20) / 20.0;
  const double high = low + uniform_int(engine, 0, 8) / 20.0;
  const std::string from = format_number(low), to = format_number(high);
  const auto number = [field](auto test) {
    return [field, test](const SampleRow& row) -> Truth {
      const auto& value = row.values.at(field);
      if (!value) return std::nullopt;
      return test(*value);
    };
  };
  switch (uniform_int(engine, 0, 7)) {
    case 0:
      return {field + " < " + from, number([=](double v) { return v < low; })};
    case 1:
      return {from + " <= " + field, number([=](double v) { return low <= v; })};
    case 2:
      return {field + " != " + from, number([=](double v) { return v != low; })};
    case 3:
      return {field + " in (" + from + ", " + to + ")",
              number([=](double v) { return v == low || v == high; })};
    case 4:
      return {field + " in [" + from + ", " + to + ")",
              number([=](double v) { return v >= low && v < high; })};
    case 5:
      return {from + " <= " + field + " < " + to,
              number([=](double v) { return low <= v && v < high; })};
    case 6:
      return {field + " is na",
              [field](const SampleRow& row) -> Truth { return !row.values.at(field).has_value(); }};
    default: {
      const std::string other = fields[uniform_int(engine, 0, 2)];
      return {field + " >= " + other, [field, other](const SampleRow& row) -> Truth {
                const auto &a = row.values.at(field), &b = row.values.at(other);
                return a && b ? Truth(*a >= *b) : std::nullopt;
              }};
    }
  }
}

Expression random_text_condition(RandomEngine& engine) {
  const std::string digit = std::to_string(uniform_int(engine, 0, 9));
  const auto tagged = [](const SampleRow& row, const std::string& tag) {
    return std::find(row.tags.begin(), row.tags.end(), tag) != row.tags.end();
  };
  const auto generator = [](const SampleRow& row, bool holds) {
    return row.generator.empty() ? std::nullopt : Truth(holds);
  };
  switch (uniform_int(engine, 0, 5)) {
    case 0:
      return {"tag = hard", [=](const SampleRow& row) -> Truth { return tagged(row, "hard"); }};
    case 1:
      return {"tag != \"narrow\"",
              [=](const SampleRow& row) -> Truth { return !tagged(row, "narrow"); }};
    case 2:
      return {"generator = maze",
              [=](const SampleRow& row) { return generator(row, row.generator == "maze"); }};
    case 3:
      return {"name like '%" + digit + "'",
              [=](const SampleRow& row) -> Truth { return row.name.back() == digit[0]; }};
    case 4:
      return {"name glob 'room_[" + digit + "]*'",
              [=](const SampleRow& row) -> Truth { return row.name[5] == digit[0]; }};
    default:
      return {"id = " + digit,
              [=](const SampleRow& row) -> Truth { return row.hash[0] == digit[0]; }};
  }
}

Expression random_expression(RandomEngine& engine, int depth) {
  const int kind = depth == 0 ? uniform_int(engine, 0, 3) : uniform_int(engine, 0, 7);
  if (kind < 3) return random_comparison(engine);
  if (kind == 3) return random_text_condition(engine);
  const Expression a = random_expression(engine, depth - 1);
  if (kind == 4)
    return {"not (" + a.text + ")", [a](const SampleRow& row) -> Truth {
              const Truth t = a.holds(row);
              return t ? Truth(!*t) : t;
            }};
  const Expression b = random_expression(engine, depth - 1);
  const bool decisive = kind == 5;  // true decides an "or", false an "and"
  return {"(" + a.text + ")" + (decisive ? " or " : " AND ") + "(" + b.text + ")",
          [=](const SampleRow& row) -> Truth {
            const Truth s = a.holds(row), t = b.holds(row);
            if (s == decisive || t == decisive) return decisive;
            return s && t ? Truth(!decisive) : std::nullopt;
          }};
}

ListSelection selection_of(const ScenarioList& list, const std::string& where,
                           const std::string& order = "") {
  const auto vocabulary = list.vocabulary({"density", "clearness", "confinement"});
  ListSelection selection;
  selection.view = sample_view();
  if (!where.empty()) selection.where = parse_selection(where, vocabulary);
  if (!order.empty()) selection.order = parse_selection_order(order, vocabulary);
  return selection;
}

std::vector<std::string> names(const ScenarioList& list, const ListSelection& selection) {
  std::vector<std::string> names;
  for (const auto& entry : list.select(selection)) names.push_back(entry.name);
  return names;
}

TEST(ListSelect, MatchesTheReferenceImplementation) {
  const TemporaryFolder folder;
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(folder / "a.scenarios", 150, 5, rows);
  RandomEngine engine(11);
  std::size_t matches = 0;
  for (int trial = 0; trial < 600; ++trial) {
    if (trial == 300)  // repeat with indexes: the results must not change
      for (const auto& [id, keys] : sample_view())
        list.create_index({"by_" + id, id, keys, {0, 0.5, 1}});
    const Expression expression = random_expression(engine, 3);
    std::vector<std::string> expected;
    for (const SampleRow& row : rows)
      if (expression.holds(row) == true) expected.push_back(row.name);
    matches += expected.size();
    ASSERT_EQ(names(list, selection_of(list, expression.text)), expected) << expression.text;
  }
  EXPECT_GT(matches, 600U * 15) << "too few matches for a meaningful test";
  EXPECT_LT(matches, 600U * 135);
}

/// A field of random numbers, and one of up to two outcomes, that are not in the list.
struct OuterFields {
  std::shared_ptr<ListField> number = std::make_shared<ListField>(),
                             text = std::make_shared<ListField>();
  OuterFields(const std::vector<SampleRow>& rows, RandomEngine& engine) {
    text->is_text = true;
    for (const SampleRow& row : rows) {
      const int kind = uniform_int(engine, 0, 5);  // 0: no value, 1: NA
      if (kind > 0)
        number->numbers[row.hash] = kind == 1 ? Value::na("why") : Value::of(kind / 4.0);
      for (int run = uniform_int(engine, 0, 2); run > 0; --run)
        text->texts[row.hash].insert(uniform_int(engine, 0, 1) == 0 ? "success" : "stuck");
    }
  }
  std::optional<double> number_of(const SampleRow& row) const {
    const auto found = number->numbers.find(row.hash);
    if (found == number->numbers.end() || found->second.is_na()) return std::nullopt;
    return found->second.number();
  }
  Truth has(const SampleRow& row, const std::string& outcome) const {
    const auto found = text->texts.find(row.hash);
    return found == text->texts.end() ? std::nullopt : Truth(found->second.count(outcome) > 0);
  }
};

TEST(ListSelect, UsesFieldsThatAreNotInTheList) {
  const TemporaryFolder folder;
  std::vector<SampleRow> rows;
  const ScenarioList list = sample_list(folder / "a.scenarios", 80, 9, rows);
  RandomEngine engine(12);
  const OuterFields outer(rows, engine);
  const auto below = [&](double limit) {
    return [&outer, limit](const SampleRow& row) -> Truth {
      const auto number = outer.number_of(row);
      return number ? Truth(*number < limit) : std::nullopt;
    };
  };
  const auto has = [&](const std::string& outcome) {
    return [&outer, outcome](const SampleRow& row) { return outer.has(row, outcome); };
  };
  const auto inverse = [](auto holds) {
    return [holds](const SampleRow& row) {
      const Truth truth = holds(row);
      return truth ? Truth(!*truth) : truth;
    };
  };
  const std::vector<Expression> expressions = {
      {"success.nd < 1", below(1)},
      {"not success.nd < 1", inverse(below(1))},
      {"Success.ND in [0, 1)", below(1)},
      {"success.nd is na",
       [&](const SampleRow& row) -> Truth { return !outer.number_of(row).has_value(); }},
      {"outcome.nd = stuck", has("stuck")},
      {"outcome.nd != stuck", inverse(has("stuck"))},
      {"outcome.nd like 'SUCC%'", has("success")},
      {"outcome.nd is na",
       [&](const SampleRow& row) -> Truth { return outer.text->texts.count(row.hash) == 0; }},
      {"success.nd < density", [&](const SampleRow& row) -> Truth {
         const auto number = outer.number_of(row), density = row.values.at("density");
         return number && density ? Truth(*number < *density) : std::nullopt;
       }}};
  SelectionVocabulary vocabulary = list.vocabulary({"density"});
  vocabulary.numbers.emplace_back("success.nd");
  vocabulary.texts.emplace_back("outcome.nd");
  name_field(vocabulary, "Success.nd", "success.nd");
  ListSelection selection;
  selection.view = sample_view();
  selection.fields = {{"success.nd", outer.number}, {"outcome.nd", outer.text}};
  for (const Expression& expression : expressions) {
    selection.where = parse_selection(expression.text, vocabulary);
    std::vector<std::string> expected;
    for (const SampleRow& row : rows)
      if (expression.holds(row) == true) expected.push_back(row.name);
    EXPECT_FALSE(expected.empty()) << expression.text;
    EXPECT_LT(expected.size(), rows.size()) << expression.text;
    EXPECT_EQ(names(list, selection), expected) << expression.text;
  }
  EXPECT_NE(list.query_plan(selection), "");
  selection.where = nullptr;
  selection.order = parse_selection_order("success.nd desc, outcome.nd", vocabulary);
  std::stable_sort(rows.begin(), rows.end(), [&](const SampleRow& a, const SampleRow& b) {
    const auto key = [&](const SampleRow& row) {
      const auto number = outer.number_of(row);
      const Truth success = outer.has(row, "success");
      // "success" follows "stuck": a scenario with both outcomes counts as the later one.
      return std::make_tuple(!number, number ? -*number : 0, !success, success.value_or(false));
    };
    return key(a) < key(b);
  });
  std::vector<std::string> expected;
  for (const SampleRow& row : rows) expected.push_back(row.name);
  EXPECT_EQ(names(list, selection), expected);
}

TEST(ListSelect, OrdersWithNaLastAndAppliesTheLimit) {
  const TemporaryFolder folder;
  std::vector<SampleRow> rows;
  const ScenarioList list = sample_list(folder / "a.scenarios", 60, 6, rows);
  for (const bool descending : {false, true}) {
    std::vector<SampleRow> sorted = rows;
    std::stable_sort(sorted.begin(), sorted.end(), [&](const SampleRow& a, const SampleRow& b) {
      const auto &x = a.values.at("density"), &y = b.values.at("density");
      if (!x || !y) return x.has_value() && !y.has_value();
      return descending ? *x > *y : *x < *y;
    });
    ListSelection selection = selection_of(list, "", descending ? "density desc" : "density");
    std::vector<std::string> expected;
    for (const SampleRow& row : sorted) expected.push_back(row.name);
    EXPECT_EQ(names(list, selection), expected);
    selection.limit = 7;
    expected.resize(7);
    EXPECT_EQ(names(list, selection), expected);
    EXPECT_EQ(list.count(selection), 7U);
  }
}

TEST(ListSelect, RestrictsToTheGivenHashes) {
  const TemporaryFolder folder;
  std::vector<SampleRow> rows;
  const ScenarioList list = sample_list(folder / "a.scenarios", 10, 7, rows);
  ListSelection selection;
  selection.hashes = {rows[7].hash, rows[2].hash, "00"};
  EXPECT_EQ(names(list, selection), (std::vector<std::string>{"room_2", "room_7"}));
  selection.hashes = std::vector<std::string>{};
  EXPECT_TRUE(names(list, selection).empty());
  selection.hashes = {"') OR 1 --"};
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "selection: ", {"') OR 1 --", "hash"},
                           [&] { list.select(selection); }));
}

TEST(ListSelect, StringsAreNeverPartOfTheQuery) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  const std::string malicious = "x'); DROP TABLE scenarios; --";
  list.add(sample_scenario(1, malicious));
  list.add(sample_scenario(2, "harmless"));
  EXPECT_EQ(names(list, selection_of(list, "name = \"" + malicious + "\"")),
            std::vector<std::string>{malicious});
  EXPECT_EQ(list.size(), 2U);
}

TEST(ListSelect, KeepsOneScenarioInMemoryAtATime) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  list.in_transaction([&] {
    for (std::uint64_t i = 0; i < 150; ++i) list.add(sample_as(Representation::Grid, i));
  });
  std::vector<std::weak_ptr<const mrpt::maps::COccupancyGridMap2D>> seen;
  list.for_each({}, [&](const ScenarioList::Entry& entry) {
    const Scenario scenario = list.read(entry.hash);
    for (const auto& earlier : seen) EXPECT_TRUE(earlier.expired());
    seen.emplace_back(scenario.grid_map());
    return true;
  });
  EXPECT_EQ(seen.size(), 150U);
}

TEST(ListSelect, VisitsContinueWhileTheListIsChanged) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  int visited = 0;
  list.in_transaction([&] {
    for (std::uint64_t i = 0; i < 200; ++i) list.add(sample_scenario(i, std::to_string(i)));
    list.for_each({}, [&](const ScenarioList::Entry& entry) {
      list.remove(entry.hash);
      list.add(sample_scenario(1000 + static_cast<std::uint64_t>(visited)));
      return ++visited < 150;
    });
  });
  EXPECT_EQ(visited, 150) << "added scenarios are not visited";
  EXPECT_EQ(list.size(), 200U);
}

TEST(ListSelect, FindsScenariosWithoutAComputedValue) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  for (std::uint64_t i = 0; i < 3; ++i) list.add(sample_scenario(i));
  const auto entries = list.entries();
  const auto keys = sample_view().at("density");
  EXPECT_EQ(list.missing_values(keys).size(), 3U);
  list.store_value(entries[0].hash, {{"density", 1, ""}, Value::of(1)});
  list.store_value(entries[2].hash, {{"density", 1, "resolution=0.05"}, Value::na("why")});
  EXPECT_EQ(list.missing_values(keys), std::vector<std::string>{entries[1].hash});
  EXPECT_EQ(list.find(entries[2].hash, keys), Value::na("why"));
  EXPECT_FALSE(list.find(entries[1].hash, keys).has_value());
}

}  // namespace
}  // namespace slalom
