// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/repeatability.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// Three runs of the method a.b, of which one differs; one of nd, which is the same.
const Manifest kManifest = {{"campaign", "x"},
                            {"repeated.00000000/a.b/0", ""},
                            {"repeated.11111111/a.b/2", "differs after 1.30 s"},
                            {"repeated.22222222/a.b/0", "differs after 0.10 s"},
                            {"repeated.33333333/nd/0", ""}};

TEST(Repeatability, IsCountedByMethodWithTheFirstDifference) {
  auto measured = repeatability_of(kManifest);
  ASSERT_EQ(measured.size(), 2U);
  EXPECT_FALSE(measured["a.b"].is_repeatable());
  EXPECT_EQ(to_string(measured["a.b"]),
            "repeatable in 1 of 3 runs; 11111111/a.b/2 differs after 1.30 s");
  EXPECT_TRUE(measured["nd"].is_repeatable());
  EXPECT_EQ(to_string(measured["nd"]), "repeatable in 1 of 1 run");
}

TEST(Repeatability, OfKeysThatNameNoRunIsNotMeasured) {
  for (const char* key :
       {"repeated.", "repeated.a", "repeated.a/b", "repeated.//", "xrepeated.a/b/0"})
    EXPECT_EQ(repeated_method(key), "") << key;
  EXPECT_EQ(repeated_method("repeated.0/a/b/0"), "a/b");
}

TEST(Repeatability, IsNotedForTheMethodsOfTheTableAndRecommendsRepetitionsIfThereAreNone) {
  ResultTable table;
  table.manifest = kManifest;
  table.methods = {"nd"};
  EXPECT_TRUE(repeatability_notes(table).empty());
  table.methods = {"a.b*", "nd"};  // marked as privileged
  table.manifest["methods.privileged"] = "a.b";
  table.repetition = {0, 0};
  ASSERT_EQ(repeatability_notes(table).size(), 1U);
  const std::string alone = repeatability_notes(table)[0];
  EXPECT_EQ(alone.find("a.b: repeatable in 1 of 3 runs; 11111111/a.b/2 differs after 1.30 s; "),
            0U);
  table.repetition = {0, 1};
  EXPECT_EQ(repeatability_notes(table)[0] + ", which [campaign] repetitions would show", alone);
}

}  // namespace
}  // namespace slalom
