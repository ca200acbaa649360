// SPDX-License-Identifier: BSD-3-Clause
#include "open_files.h"
#include "shared_memory.h"

#include <slalom/core/error.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <fstream>
#include <string>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace slalom {
namespace {

/// Memory with its writer.
struct Written {
  explicit Written(const std::string& text) { write(text); }
  void write(const std::string& text) {
    writer.clear();
    writer.append(file.number(), text.data(), text.size());
    writer.finish();
  }

  FileDescriptor file = create_shared_memory();
  SharedWriter writer{file.number()};
};

std::string text_of(const SharedArray<std::byte>& memory) {
  return {reinterpret_cast<const char*>(memory.data()), memory.size()};
}

std::string contents_of(const Written& memory) {
  return text_of(SharedReader().read(memory.file.number()));
}

TEST(SharedMemory, IsReadAsWritten) {
  for (const std::size_t size : {1, 64, 100000, 3000000}) {  // beyond the initial capacity
    const std::string text(size, 'x');
    EXPECT_EQ(contents_of(Written(text)), text);
  }
  Written parts("one");
  parts.writer.append(parts.file.number(), " and two", 8);
  parts.writer.finish();
  EXPECT_EQ(contents_of(parts), "one and two");
}

TEST(SharedMemory, CannotBeChangedButByItsWriter) {
  const Written memory("original");
  EXPECT_TRUE(is_sealed(memory.file.number()));
  EXPECT_EQ(pwrite(memory.file.number(), "forged", 6, 64), -1);
  EXPECT_EQ(ftruncate(memory.file.number(), 1), -1);
  EXPECT_EQ(mmap(nullptr, 8, PROT_READ | PROT_WRITE, MAP_SHARED, memory.file.number(), 0),
            MAP_FAILED);
  EXPECT_EQ(contents_of(memory), "original");
}

TEST(SharedMemory, AMappingCannotBeMadeWritable) {
  const Written memory("original");
  const SharedArray<std::byte> text = SharedReader().read(memory.file.number());
  auto* page = const_cast<std::byte*>(text.data()) - 64;
  EXPECT_NE(mprotect(page, 64 + text.size(), PROT_READ | PROT_WRITE), 0);
  EXPECT_EQ(text_of(text), "original");
}

TEST(SharedMemory, IsWrittenAgainWhereItIsMapped) {
  Written memory("first"), other("other");
  SharedReader reader;
  const SharedArray<std::byte> first = reader.read(memory.file.number());
  EXPECT_EQ(text_of(reader.read(other.file.number())), "other");
  memory.write("again");
  const SharedArray<std::byte> again = reader.read(memory.file.number());
  EXPECT_EQ(text_of(again), "again");
  EXPECT_EQ(again.data(), first.data());
  memory.write("a");
  EXPECT_EQ(text_of(reader.read(memory.file.number())), "a");
  const std::string larger(1000000, 'l');
  memory.write(larger);
  EXPECT_EQ(text_of(reader.read(memory.file.number())), larger);
  EXPECT_EQ(text_of(reader.read(other.file.number())), "other");
  EXPECT_TRUE(memory.writer.writes(memory.file.number()));
  EXPECT_FALSE(memory.writer.writes(other.file.number()));
}

TEST(SharedMemory, AReaderKeepsFewMappings) {
  const auto mapped = [] {
    std::ifstream maps("/proc/self/maps");
    std::size_t count = 0;
    for (std::string line; std::getline(maps, line);)
      count += line.find(" r--s ") != std::string::npos && line.find("slalom") != std::string::npos;
    return count;
  };
  const std::string large(20 << 20, 'l');
  SharedReader reader;
  for (int i = 0; i < 4; ++i) {
    const Written memory(large);
    EXPECT_EQ(reader.read(memory.file.number()).size(), large.size());
  }
  EXPECT_EQ(mapped(), 2U) << "that of the last, and one of at most 32 MiB";
}

TEST(SharedMemory, MemoryThatOthersCanChangeIsNotRead) {
  const FileDescriptor memory = create_shared_memory();
  const std::string text(128, '\1');
  ASSERT_EQ(write(memory.number(), text.data(), text.size()), 128);
  EXPECT_FALSE(is_sealed(memory.number()));
  EXPECT_EQ(SharedReader().read(memory.number()).size(), 0U);
  EXPECT_EQ(contents_of(Written("")), "");
}

TEST(SharedMemory, IsNoneWithoutFreeDescriptors) {
  rlimit before = {};
  getrlimit(RLIMIT_NOFILE, &before);
  rlimit none = before;
  none.rlim_cur = 0;
  setrlimit(RLIMIT_NOFILE, &none);
  const bool created = static_cast<bool>(create_shared_memory());
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_FALSE(created);
}

TEST(SharedMemory, OtherFilesCannotBeWritten) {
  EXPECT_THROW(SharedWriter(-1), Error);
  const FileDescriptor sealed = create_shared_memory();
  ASSERT_EQ(fcntl(sealed.number(), F_ADD_SEALS, F_SEAL_GROW), 0);
  EXPECT_THROW(SharedWriter{sealed.number()}, Error);
}

TEST(SharedMemory, ClosesItsDescriptor) {
  const std::size_t before = open_files().size();
  FileDescriptor memory = create_shared_memory();
  EXPECT_EQ(open_files().size(), before + 1);
  memory = create_shared_memory();
  EXPECT_EQ(open_files().size(), before + 1);
  const FileDescriptor moved = std::move(memory);
  memory = FileDescriptor();
  EXPECT_EQ(open_files().size(), before + 1);
}

}  // namespace
}  // namespace slalom
