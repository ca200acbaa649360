// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>

#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <array>
#include <cstring>
#include <vector>
#include <xxhash.h>

namespace slalom {

double uniform_real(RandomEngine& engine, double low, double high) {
  return low < high ? boost::random::uniform_real_distribution<double>(low, high)(engine) : low;
}

int uniform_int(RandomEngine& engine, int low, int high) {
  return boost::random::uniform_int_distribution<int>(low, high)(engine);
}

double normal(RandomEngine& engine, double mean, double sigma) {
  return boost::random::normal_distribution<double>(mean, sigma)(engine);
}

std::uint64_t derive_seed(std::uint64_t parent, std::string_view label, std::uint64_t index) {
  std::vector<unsigned char> bytes(16 + label.size());
  for (int i = 0; i < 8; ++i) {
    bytes[i] = static_cast<unsigned char>(parent >> (8 * i));
    bytes[8 + i] = static_cast<unsigned char>(index >> (8 * i));
  }
  std::memcpy(bytes.data() + 16, label.data(), label.size());
  return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace slalom
