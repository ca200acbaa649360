// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/random/mersenne_twister.hpp>

#include <cstdint>
#include <string_view>

namespace slalom {

/// The random engine, passed to every function that draws random numbers. Boost.Random's engines
/// and distributions give the same numbers on every platform, unlike the standard library's.
using RandomEngine = boost::random::mt19937_64;

double uniform_real(RandomEngine& engine, double low, double high);  ///< in [low, high)
int uniform_int(RandomEngine& engine, int low, int high);            ///< in [low, high]
double normal(RandomEngine& engine, double mean, double sigma);

/// The seed of the stream `label` (and index) of a parent seed. Streams with different labels or
/// indexes are independent of each other and of the order of calls.
std::uint64_t derive_seed(std::uint64_t parent, std::string_view label, std::uint64_t index = 0);

}  // namespace slalom
