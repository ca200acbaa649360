// SPDX-License-Identifier: BSD-3-Clause
#include "aligned_copy.h"

#include <slalom/core/array_stream.h>
#include <slalom/core/error.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace slalom {
namespace {

const std::vector<float> kFloats = {1.5F, -2.25F, 1e30F};
const std::vector<std::uint16_t> kWords(1000, 65535);

std::string written() {
  std::string bytes;
  ArrayWriter writer([&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  });
  writer.write(kFloats.data(), kFloats.size());
  writer.write(kFloats.data(), 0);
  writer.write(SharedArray<std::uint16_t>(std::vector<std::uint16_t>(kWords)));
  return bytes;
}

void read_all(const std::string& bytes) {
  ArrayReader reader(aligned_copy(bytes));
  const auto floats = reader.read<float>(kFloats.size());
  EXPECT_EQ(std::vector<float>(floats.begin(), floats.end()), kFloats);
  EXPECT_EQ(reader.read<double>(0).size(), 0U);
  const auto words = reader.read<std::uint16_t>(kWords.size());
  EXPECT_EQ(std::vector<std::uint16_t>(words.begin(), words.end()), kWords);
  reader.expect_end();
}

TEST(ArrayStream, ReadsWhatWasWritten) {
  EXPECT_NO_THROW(read_all(written()));
}

TEST(ArrayStream, ArraysAreAlignedAndStayInTheMemory) {
  const SharedArray<std::byte> memory = aligned_copy(written());
  ArrayReader reader(memory);
  const auto floats = reader.read<float>(kFloats.size());
  reader.read<float>(0);
  const auto words = reader.read<std::uint16_t>(kWords.size());
  for (const void* data :
       {static_cast<const void*>(floats.data()), static_cast<const void*>(words.data())}) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(data) % 64, 0U);
    EXPECT_GT(data, memory.data());
    EXPECT_LT(data, memory.end());
  }
}

TEST(ArrayStream, AnArrayOutlivesItsReader) {
  const auto floats = ArrayReader(aligned_copy(written())).read<float>(kFloats.size());
  EXPECT_EQ(floats[1], -2.25F);
}

TEST(ArrayStream, MemoryThatEndsEarlyOrLateIsRefused) {
  const std::string bytes = written();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(read_all(bytes.substr(0, size)), Error) << size;
  EXPECT_THROW(read_all(bytes + '\0'), Error);
}

TEST(ArrayStream, AnArrayOfAnotherSizeIsRefused) {
  for (const std::size_t count : {0U, 2U, 4U, 1U << 30U})
    EXPECT_THROW(ArrayReader(aligned_copy(written())).read<float>(count), Error) << count;
  std::string bytes = written();
  std::memset(bytes.data(), 0xFF, 8);  // the size of the first array
  EXPECT_THROW(read_all(bytes), Error);
}

}  // namespace
}  // namespace slalom
