#pragma once

#include <boost/random/mersenne_twister.hpp>

#include <cstdint>
#include <string_view>

namespace slalom {

/// The one engine; it is passed in wherever random numbers are drawn. Boost.Random's engines and
/// distributions give the same numbers on every platform, which the standard library's do not.
using RandomEngine = boost::random::mt19937_64;

double uniform_real(RandomEngine& engine, double low, double high);  ///< in [low, high)
int uniform_int(RandomEngine& engine, int low, int high);            ///< in [low, high]
double normal(RandomEngine& engine, double mean, double sigma);

/// A seed for the stream `label` (and index) under a parent seed. Streams with different labels or
/// indexes are independent of each other and of the order in which they are asked for.
std::uint64_t derive_seed(std::uint64_t parent, std::string_view label, std::uint64_t index = 0);

}  // namespace slalom
