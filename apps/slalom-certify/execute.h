// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parameter.h"

#include <slalom/app/campaign_program.h>

#include <string>

namespace slalom {

/// A question about a limit: all that the answer depends on, besides the .ini.
struct LimitQuestion {
  std::string method;
  Parameter parameter;
  Bins bins;
  LimitOptions search;
};

/// The question with the campaign that answers it.
struct LimitJob {
  LimitQuestion question;
  IniFile ini;  ///< of a campaign with this method, and the family as its only source of scenarios
  CampaignConfig config;
};

/// Checks the question before any run. Throws Error (Usage) for one that cannot be answered.
LimitJob make_limit_job(LimitQuestion question, IniFile ini);

/// The answer.
struct LimitAnswer {
  LimitResult result;
  std::string outcomes;  ///< hash of scenarios, outcomes and trajectories of all runs, in order
};

/// Answers the question; the same for any number of jobs. Throws Interrupted, Error: Usage if easy
/// and hard are exchanged, Job for runs that cannot be executed.
LimitAnswer execute(const LimitJob& job, const CampaignArguments& arguments);

}  // namespace slalom
