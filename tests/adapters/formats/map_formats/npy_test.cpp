// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"
#include "npy.h"
#include "npy_files.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

testing::AssertionResult rejects_npy(const std::string& bytes,
                                     std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::File, "a.npy: ", words, [&] { parse_npy(bytes, "a.npy"); });
}

std::string with_header(const std::string& header) {
  return npy_with_header(header, {1, 2, 3, 4});
}

TEST(Npy, ReadsIntegersInRowMajorOrder) {
  const NpyTable table = parse_npy(npy(2, 3, {1, 2, 3, -4, 5, 1LL << 40}), "a.npy");
  EXPECT_EQ(table.rows, 2U);
  EXPECT_EQ(table.columns, 3U);
  EXPECT_EQ(table.at(0, 2), 3);
  EXPECT_EQ(table.at(1, 0), -4);
  EXPECT_EQ(table.at(1, 2), 1LL << 40);
}

TEST(Npy, ReadsKeysOfTheHeaderInAnyOrder) {
  const auto table =
      parse_npy(with_header("{ 'shape':(2,2,) ,'fortran_order' : False,'descr':'<i8'}"), "a.npy");
  EXPECT_EQ(table.at(1, 1), 4);
}

TEST(Npy, ReadsFormatTwo) {
  std::string bytes = npy(1, 1, {7});
  bytes[6] = 2;  // then the length of the header has 4 bytes
  bytes.insert(10, std::string(2, '\0'));
  EXPECT_EQ(parse_npy(bytes, "a.npy").at(0, 0), 7);
}

TEST(Npy, RejectsOtherNumberTypesAndOrders) {
  EXPECT_TRUE(
      rejects_npy(with_header("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }"),
                  {"number type", "'<i8'", " at byte "}));
  EXPECT_TRUE(rejects_npy(
      with_header("{'descr': '>i8', 'fortran_order': False, 'shape': (2, 2), }"), {"number type"}));
  EXPECT_TRUE(rejects_npy(with_header("{'descr': '<i8', 'fortran_order': True, 'shape': (2, 2), }"),
                          {"Fortran order"}));
  EXPECT_TRUE(rejects_npy(with_header("{'descr': '<i8', 'fortran_order': False, 'shape': (4,), }"),
                          {"is not two-dimensional"}));
  EXPECT_TRUE(
      rejects_npy(with_header("{'descr': '<i8', 'fortran_order': False, 'shape': (2, 2, 1), }"),
                  {"missing ')'"}));
}

TEST(Npy, RejectsInvalidSizesBeforeAllocatingMemory) {
  for (const std::string shape : {"(1000000, 1000000)", "(99999999999999999999, 1)", "(0, 4)",
                                  "(1000001, 1)", "(4294967296, 4294967296)"})
    EXPECT_TRUE(rejects_npy(
        with_header("{'descr': '<i8', 'fortran_order': False, 'shape': " + shape + ", }"),
        {" numbers at byte "}))
        << shape;
  EXPECT_TRUE(rejects_npy(npy(2, 3, {1, 2, 3, 4, 5}), {"40 bytes", "byte 128;", "48 for 2 x 3"}));
  EXPECT_TRUE(rejects_npy(npy(2, 2, {1, 2, 3, 4, 5}), {"40 bytes", "byte 128;", "32 for 2 x 2"}));
}

TEST(Npy, RejectsMissingDuplicateOrUnknownKeys) {
  EXPECT_TRUE(rejects_npy(with_header("{'descr': '<i8', 'shape': (2, 2)}"),
                          {"missing descr, fortran_order or shape"}));
  EXPECT_TRUE(
      rejects_npy(with_header("{'descr': '<i8', 'descr': '<i8'}"), {"unexpected key 'descr'"}));
  EXPECT_TRUE(rejects_npy(with_header("{'dtype': '<i8'}"), {"unexpected key 'dtype'"}));
  EXPECT_TRUE(rejects_npy(with_header(""), {"missing '{'"}));
}

TEST(Npy, RejectsTruncatedFilesAndHandlesChangedBytes) {
  const std::string bytes = npy(2, 2, {1, 0, 0, 1});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_TRUE(rejects_npy(bytes.substr(0, size), {})) << size;
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
