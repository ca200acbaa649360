#include "fork_memory.h"

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace slalom {
namespace {

/// MADV_COLLAPSE, which the C library of Debian 12 declares only for newer kernels.
constexpr int kCollapse = 25;

struct Region {
  std::uintptr_t begin = 0, end = 0;
  std::size_t small = 0;  ///< bytes in small pages that are not of a file
};

/// The number in kB after `label` in a line of smaps, in bytes; zero if it is another line.
std::size_t bytes_in(const std::string& line, const std::string& label) {
  if (line.compare(0, label.size(), label) != 0) return 0;
  return std::strtoull(line.c_str() + label.size(), nullptr, 10) * 1024;
}

/// Of `smaps`, or the one region of `smaps_rollup`, which takes a fraction of the time.
std::vector<Region> read_regions(const char* file) {
  std::vector<Region> regions;
  std::ifstream maps(file);
  for (std::string line; std::getline(maps, line);) {
    Region next;
    if (std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR " ", &next.begin, &next.end) == 2)
      regions.push_back(next);
    if (regions.empty()) continue;
    regions.back().small += bytes_in(line, "Anonymous:");
    regions.back().small -= bytes_in(line, "AnonHugePages:");
  }
  return regions;
}

/// Bytes that are not of files, in pages of any size; this takes microseconds.
std::size_t own_memory() {
  std::size_t size = 0, resident = 0, of_files = 0;
  if (!(std::ifstream("/proc/self/statm") >> size >> resident >> of_files)) return 0;
  return (resident - of_files) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::size_t memory_in_small_pages() {
  const std::vector<Region> all = read_regions("/proc/self/smaps_rollup");
  return all.empty() ? 0 : all.front().small;
}

/// Sparse memory would grow: a huge page is all there.
bool is_worth_collapsing(const Region& region) {
  constexpr std::size_t kLeast = std::size_t{4} << 20;
  return region.small >= kLeast && region.small * 4 >= (region.end - region.begin) * 3;
}

}  // namespace

bool ForkMemory::collapse() {
  const std::size_t own = own_memory();
  if (own < known_ + kStep) return false;
  known_ = own;
  if (memory_in_small_pages() < kStep) return false;
  for (const Region& region : read_regions("/proc/self/smaps"))
    if (is_worth_collapsing(region))
      madvise(reinterpret_cast<void*>(region.begin), region.end - region.begin, kCollapse);
  return true;
}

}  // namespace slalom
