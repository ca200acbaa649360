// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "result_fixture.h"

#include <slalom/analysis/bins.h>
#include <slalom/core/error.h>
#include <slalom/core/random.h>
#include <slalom/core/text.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

TEST(Bins, ParseAllForms) {
  EXPECT_EQ(parse_bin_spec("all").kind, BinSpec::Kind::All);
  const BinSpec edges = parse_bin_spec("density:0, 0.1,0.4");
  EXPECT_EQ(edges.kind, BinSpec::Kind::Edges);
  EXPECT_EQ(edges.descriptor, "density");
  EXPECT_EQ(edges.edges, (std::vector<double>{0, 0.1, 0.4}));
  EXPECT_EQ(parse_bin_spec("density:q4").count, 4);
  EXPECT_EQ(parse_bin_spec("density:q4").kind, BinSpec::Kind::Quantiles);
  EXPECT_EQ(parse_bin_spec("density:3").kind, BinSpec::Kind::EqualWidth);
  EXPECT_EQ(parse_bin_spec("density:@by_density").index, "by_density");
  EXPECT_EQ(parse_bin_specs("density:q4; all").size(), 2u);
}

TEST(Bins, RejectMalformedSpecifications) {
  for (const char* spec :
       {"", ":4", "density,", "0,0.1", "@x", "density:", "density:0", "density:-3", "density:x",
        "density:1,x", "density:1,1", "density:2,1", "density:nan,1", "density:q", "density:q0",
        "density:@", "density:equal:3", "density:9999999"}) {
    EXPECT_TRUE(throws_error(ErrorKind::Usage, "rows", {"expected all, ID, ID:EDGE"}, [&] {
      parse_bin_spec(spec);
    })) << spec;
  }
}

TEST(Bins, OfADescriptorAloneAreQuarters) {
  const auto specs = parse_bin_specs("all; density");
  EXPECT_EQ(specs.at(1).descriptor, "density");
  EXPECT_EQ(specs.at(1).kind, BinSpec::Kind::Quantiles);
  EXPECT_EQ(specs.at(1).count, 4);
}

TEST(Bins, OfEqualValuesIsLabeledWithTheValue) {
  for (const double value : {144.0, 0.0140625, 0.0, -3.5}) {
    ResultFixture fixture;
    fixture.add_scenario(Value::of(value));
    fixture.add_scenario(Value::of(value));
    const auto bins = make_bins(parse_bin_spec("density:q4"), fixture.table);
    ASSERT_EQ(bins.size(), 1u);
    EXPECT_EQ(bins[0].label(), format_number(value));
    EXPECT_TRUE(bins[0].contains(value));
  }
}

TEST(Bins, AreHalfOpenAndTheLastIsClosed) {
  ResultFixture fixture;
  fixture.add_scenario(Value::of(0.2));
  const auto bins = make_bins(parse_bin_spec("density:0,0.1,0.2"), fixture.table);
  ASSERT_EQ(bins.size(), 2u);
  EXPECT_EQ(bins[0].label(), "[0, 0.1)");
  EXPECT_EQ(bins[1].label(), "[0.1, 0.2]");
  EXPECT_FALSE(bins[0].contains(0.1));
  EXPECT_TRUE(bins[1].contains(0.1));
  EXPECT_TRUE(bins[1].contains(0.2));
  EXPECT_FALSE(bins[1].contains(0.2000001));
  EXPECT_FALSE(bins[0].contains(-1e-9));
}

TEST(Bins, SuggestTheNearestDescriptor) {
  ResultFixture fixture;
  fixture.add_scenario(Value::of(0.2));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "rows", {"'densty'", "expected 'density'"},
                           [&] { make_bins(parse_bin_spec("densty:4"), fixture.table); }));
}

TEST(Bins, QuantileBinsContainAboutEqualNumbersOfScenarios) {
  ResultFixture fixture;
  RandomEngine engine(4);
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) {
    values.push_back(std::exp(normal(engine, 0, 1)));
    fixture.add_scenario(Value::of(values.back()));
  }
  const auto bins = make_bins(parse_bin_spec("density:q4"), fixture.table);
  ASSERT_EQ(bins.size(), 4u);
  for (const Bin& bin : bins) {
    const auto inside = std::count_if(values.begin(), values.end(),
                                      [&](double value) { return bin.contains(value); });
    EXPECT_NEAR(static_cast<double>(inside), 100, 10);  // rounding of edges moves a few
  }
}

TEST(Bins, CountedBinsContainEveryValueExactlyOnce) {
  RandomEngine engine(8);
  for (int round = 0; round < 300; ++round) {
    ResultFixture fixture;
    std::vector<double> values;
    const double scale = std::pow(10.0, uniform_int(engine, -9, 9));
    for (int i = 0; i < uniform_int(engine, 1, 12); ++i) {
      values.push_back(scale * uniform_real(engine, -1, 1));
      fixture.add_scenario(Value::of(values.back()));
    }
    for (const char* spec : {"density:1", "density:q4", "density:7"}) {
      const auto bins = make_bins(parse_bin_spec(spec), fixture.table);
      for (const double value : values) {
        EXPECT_EQ(std::count_if(bins.begin(), bins.end(),
                                [&](const Bin& bin) { return bin.contains(value); }),
                  1)
            << spec << " " << value;
      }
    }
  }
}

TEST(Bins, EqualValuesGiveOneBinAndNoValuesGiveNone) {
  ResultFixture fixture;
  fixture.add_scenario(Value::na("unsolvable"));
  EXPECT_TRUE(make_bins(parse_bin_spec("density:q4"), fixture.table).empty());
  fixture.add_scenario(Value::of(0.5));
  fixture.add_scenario(Value::of(0.5));
  EXPECT_EQ(make_bins(parse_bin_spec("density:q4"), fixture.table).size(), 1u);
}

}  // namespace
}  // namespace slalom
