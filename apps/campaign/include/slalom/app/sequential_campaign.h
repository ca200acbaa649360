#pragma once

#include <slalom/app/campaign_program.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// When a campaign that adds runs only where they are needed may stop.
struct SequentialArguments {
  std::string until;         ///< a PrecisionRule: "interval(success) < 0.1 in density:10"
  std::size_t max_runs = 0;  ///< no further batch after that many runs; 0: no limit
};

/// How it went.
struct SequentialReport {
  CampaignReport campaign;
  bool reached = false;  ///< every cell is known as precisely as was asked for
  std::string text;      ///< the cells, and why it stopped, for people
};

/// Runs the campaign in batches until each method's interval is narrow enough in each bin. The
/// scenarios that the .ini names are the pool: they are described first, so that bins are fixed
/// before anything runs. Then each look at the results is followed by a batch of scenarios from the
/// bins that are not known well enough, in the order of the pool; all methods drive all of them, so
/// that comparisons stay paired. The first batch has kFirstBatch scenarios of each bin, each
/// further one half as many as the bin has. Looks spend the error probability as look_confidence()
/// says. Stops when all is reached, the pool has no more scenarios for open bins, or max_runs is
/// met. The same for any number of jobs. Throws Error (Usage) for a rule that does not fit the
/// campaign.
SequentialReport run_until(const IniFile& ini, const CampaignArguments& arguments,
                           const SequentialArguments& sequential, std::vector<Scenario> pool,
                           const std::string& results_path);

constexpr std::size_t kFirstBatch = 10;

}  // namespace slalom
