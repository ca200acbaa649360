// SPDX-License-Identifier: BSD-3-Clause
// The results of one campaign to the bit, as Box2D tests its determinism: a change that alters them
// is noticed, and says so by changing the hash.
#include "program_run.h"

#include <cstdint>
#include <cstdio>

namespace slalom {
namespace {

/// FNV-1a, 64 bits.
std::string fnv1a(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  char hex[17];
  std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(hash));
  return hex;
}

class Golden : public ProgramTest {};

TEST_F(Golden, ACampaignHasTheSameBytesWithAnyNumberOfWorkers) {
  write("small.ini", kSmallCampaign);
  for (const std::string workers : {"1", "2", "3", "8"}) {
    const ProgramResult result = run("slalom-evaluate small.ini -o out" + workers + " -j " +
                                     workers + " --quiet --set campaign.repetitions=2");
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string dump = run("slalom-analyze dump out" + workers + "/runs.results").out;
    EXPECT_EQ(std::count(dump.begin(), dump.end(), '\n'), 16);
    EXPECT_EQ(fnv1a(dump), "6a6633d45c99fec1") << workers << " workers";
  }
}

}  // namespace
}  // namespace slalom
