#include "map_files.h"
#include "npy.h"
#include "npy_files.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

std::string refusal(const std::string& bytes) {
  return error_text(Culprit::File, [&] { parse_npy(bytes, "a.npy"); });
}

std::string with_head(const std::string& head) {
  return npy_with_head(head, {1, 2, 3, 4});
}

TEST(Npy, ReadsWholeNumbersRowByRow) {
  const NpyTable table = parse_npy(npy(2, 3, {1, 2, 3, -4, 5, 1LL << 40}), "a.npy");
  EXPECT_EQ(table.rows, 2U);
  EXPECT_EQ(table.columns, 3U);
  EXPECT_EQ(table.at(0, 2), 3);
  EXPECT_EQ(table.at(1, 0), -4);
  EXPECT_EQ(table.at(1, 2), 1LL << 40);
}

TEST(Npy, ReadsTheHeadWhateverTheOrderOfItsKeys) {
  const auto table =
      parse_npy(with_head("{ 'shape':(2,2,) ,'fortran_order' : False,'descr':'<i8'}"), "a.npy");
  EXPECT_EQ(table.at(1, 1), 4);
}

TEST(Npy, ReadsFormatTwo) {
  std::string bytes = npy(1, 1, {7});
  bytes[6] = 2;  // the length of the head has 4 bytes then
  bytes.insert(10, std::string(2, '\0'));
  EXPECT_EQ(parse_npy(bytes, "a.npy").at(0, 0), 7);
}

TEST(Npy, RefusesOtherKindsOfNumbersAndOrders) {
  EXPECT_TRUE(has(refusal(with_head("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }")),
                  "a.npy: holds numbers of another kind than '<i8' at byte "));
  EXPECT_TRUE(has(refusal(with_head("{'descr': '>i8', 'fortran_order': False, 'shape': (2, 2), }")),
                  "holds numbers of another kind"));
  EXPECT_TRUE(has(refusal(with_head("{'descr': '<i8', 'fortran_order': True, 'shape': (2, 2), }")),
                  "does not hold its numbers row by row"));
  EXPECT_TRUE(has(refusal(with_head("{'descr': '<i8', 'fortran_order': False, 'shape': (4,), }")),
                  "is not two-dimensional"));
  EXPECT_TRUE(
      has(refusal(with_head("{'descr': '<i8', 'fortran_order': False, 'shape': (2, 2, 1), }")),
          "has no ')'"));
}

TEST(Npy, RefusesWhatCannotBeBeforeItTakesMemory) {
  for (const std::string shape : {"(1000000, 1000000)", "(99999999999999999999, 1)", "(0, 4)",
                                  "(1000001, 1)", "(4294967296, 4294967296)"})
    EXPECT_TRUE(has(
        refusal(with_head("{'descr': '<i8', 'fortran_order': False, 'shape': " + shape + ", }")),
        " numbers at byte "))
        << shape;
  EXPECT_EQ(refusal(npy(2, 3, {1, 2, 3, 4, 5})),
            "a.npy: holds 40 bytes from byte 128 on; expected 48 of 2 x 3 numbers");
  EXPECT_EQ(refusal(npy(2, 2, {1, 2, 3, 4, 5})),
            "a.npy: holds 40 bytes from byte 128 on; expected 32 of 2 x 2 numbers");
}

TEST(Npy, RefusesKeysThatAreMissingTwiceOrUnknown) {
  EXPECT_TRUE(has(refusal(with_head("{'descr': '<i8', 'shape': (2, 2)}")), "lacks one of"));
  EXPECT_TRUE(has(refusal(with_head("{'descr': '<i8', 'descr': '<i8'}")), "has the key 'descr'"));
  EXPECT_TRUE(has(refusal(with_head("{'dtype': '<i8'}")), "has the key 'dtype'"));
  EXPECT_TRUE(has(refusal(with_head("")), "has no '{'"));
}

TEST(Npy, RefusesEveryTruncatedFileAndSurvivesEveryChangedByte) {
  const std::string bytes = npy(2, 2, {1, 0, 0, 1});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(refusal(bytes.substr(0, size)), "") << size;
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (const int bit : {0, 3, 7}) {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ (1 << bit));
      try {
        EXPECT_LE(parse_npy(changed, "a.npy").values.size(), 4U);
      } catch (const Error& e) {
        EXPECT_EQ(e.exit_status(), 3);
      }
    }
}

}  // namespace
}  // namespace slalom
