#include "fork_memory.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

/// Memory in pages of 4 KiB, and the bytes of it that are in huge pages.
class SmallPages {
 public:
  explicit SmallPages(std::size_t size) : size_(size) {
    void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) std::abort();
    bytes_ = static_cast<unsigned char*>(memory);
    madvise(memory, size, MADV_NOHUGEPAGE);
    for (std::size_t i = 0; i < size; i += 512) bytes_[i] = value_at(i);
    madvise(memory, size, MADV_HUGEPAGE);  // allowed from now on, but the pages are there
  }
  ~SmallPages() { munmap(bytes_, size_); }
  SmallPages(const SmallPages&) = delete;
  SmallPages& operator=(const SmallPages&) = delete;

  bool is_unchanged() const {
    for (std::size_t i = 0; i < size_; i += 512)
      if (bytes_[i] != value_at(i)) return false;
    return true;
  }
  void change() { bytes_[0] ^= 1U; }

  std::size_t in_huge_pages() const {
    std::ifstream maps("/proc/self/smaps");
    bool here = false;
    for (std::string line; std::getline(maps, line);) {
      unsigned long begin = 0, end = 0;
      if (std::sscanf(line.c_str(), "%lx-%lx ", &begin, &end) == 2)
        here = begin == reinterpret_cast<unsigned long>(bytes_);
      if (here && line.rfind("AnonHugePages:", 0) == 0)
        return std::strtoul(line.c_str() + 14, nullptr, 10) * 1024;
    }
    return 0;
  }

 private:
  std::size_t size_;
  unsigned char* bytes_ = nullptr;
  static unsigned char value_at(std::size_t i) { return static_cast<unsigned char>(i / 512 % 251); }
};

bool can_collapse() {
  void* page = aligned_alloc(kHugePage, kHugePage);
  static_cast<char*>(page)[0] = 1;
  const bool can = madvise(page, kHugePage, 25 /* MADV_COLLAPSE */) == 0;
  std::free(page);
  return can;
}

TEST(ForkMemory, IsPutIntoHugePagesWhenItHasGrown) {
  if (!can_collapse()) GTEST_SKIP() << "needs Linux 6.1 with huge pages";
  SmallPages pages(2 * ForkMemory::kStep);
  ForkMemory memory;
  ASSERT_EQ(pages.in_huge_pages(), 0U);
  EXPECT_TRUE(memory.collapse());
  EXPECT_GE(pages.in_huge_pages(), 2 * ForkMemory::kStep - 2 * kHugePage);  // all but the ends
  EXPECT_TRUE(pages.is_unchanged());
  const SmallPages few(ForkMemory::kStep / 2);
  EXPECT_FALSE(memory.collapse()) << "it has grown by less than a step";
  const SmallPages more(ForkMemory::kStep);
  EXPECT_TRUE(memory.collapse());
  EXPECT_GT(more.in_huge_pages(), 0U);
}

TEST(ForkMemory, InHugePagesIsStillCopiedForAProcess) {
  SmallPages pages(2 * ForkMemory::kStep);
  ForkMemory().collapse();
  const pid_t child = fork();
  if (child == 0) {
    const bool same = pages.is_unchanged();
    pages.change();
    _exit(same && !pages.is_unchanged() ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(pages.is_unchanged());
}

}  // namespace
}  // namespace slalom
