#include "open_files.h"
#include "shared_memory.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <sys/mman.h>
#include <sys/resource.h>

namespace slalom {
namespace {

FileDescriptor sealed(const std::string& text) {
  FileDescriptor memory = create_shared_memory();
  append_to_shared_memory(memory.number(), text.data(), text.size());
  EXPECT_TRUE(seal_shared_memory(memory.number()));
  return memory;
}

std::string text_of(const SharedArray<std::byte>& memory) {
  return {reinterpret_cast<const char*>(memory.data()), memory.size()};
}

TEST(SharedMemory, IsMappedAsWritten) {
  const std::string text(10000, 'x');
  EXPECT_EQ(text_of(map_shared_memory(sealed(text).number())), text);
}

TEST(SharedMemory, CannotBeChangedAfterItIsSealed) {
  const FileDescriptor memory = sealed("original");
  EXPECT_EQ(pwrite(memory.number(), "forged", 6, 0), -1);
  EXPECT_EQ(ftruncate(memory.number(), 1), -1);
  EXPECT_EQ(ftruncate(memory.number(), 100), -1);
  EXPECT_EQ(mmap(nullptr, 8, PROT_READ | PROT_WRITE, MAP_SHARED, memory.number(), 0), MAP_FAILED);
  EXPECT_EQ(text_of(map_shared_memory(memory.number())), "original");
}

TEST(SharedMemory, AMappingThatIsMadeWritableIsACopy) {
  const FileDescriptor memory = sealed("original");
  const SharedArray<std::byte> innocent = map_shared_memory(memory.number());
  const SharedArray<std::byte> changed = map_shared_memory(memory.number());
  auto* bytes = const_cast<std::byte*>(changed.data());
  ASSERT_EQ(mprotect(bytes, changed.size(), PROT_READ | PROT_WRITE), 0);
  std::memcpy(bytes, "forged", 6);
  EXPECT_EQ(text_of(changed), "forgedal");
  EXPECT_EQ(text_of(innocent), "original");
  EXPECT_EQ(text_of(map_shared_memory(memory.number())), "original");
}

TEST(SharedMemory, MemoryThatCanStillChangeIsNotMapped) {
  const FileDescriptor memory = create_shared_memory();
  append_to_shared_memory(memory.number(), "text", 4);
  EXPECT_EQ(map_shared_memory(memory.number()).size(), 0U);
  EXPECT_EQ(map_shared_memory(sealed("").number()).size(), 0U);
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

TEST(SharedMemory, ClosesItsDescriptor) {
  const std::size_t before = open_files().size();
  FileDescriptor memory = sealed("one");
  EXPECT_EQ(open_files().size(), before + 1);
  memory = sealed("two");
  EXPECT_EQ(open_files().size(), before + 1);
  const FileDescriptor moved = std::move(memory);
  memory = FileDescriptor();
  EXPECT_EQ(text_of(map_shared_memory(moved.number())), "two");
}

}  // namespace
}  // namespace slalom
