#include "interpreters.h"
#include "row_table.h"

#include <slalom/analysis/performance_profile.h>

namespace slalom {
namespace {

double share_at(const PerformanceProfile& profile, double ratio) {
  double share = 0;
  for (const ProfileStep& step : profile.steps) {
    if (step.ratio <= ratio) share = step.share;
  }
  return share;
}

DataTable steps_table(const ProfileTable& profiles) {
  RowTable rows("profile_" + profiles.column.info.id, "Performance profile, steps");
  for (const PerformanceProfile& profile : profiles.profiles) {
    for (const ProfileStep& step : profile.steps) {
      rows.begin_row();
      rows.add("method", Field{profile.method});
      rows.add("ratio", std::optional(step.ratio));
      rows.add("share", std::optional(step.share));
    }
  }
  return rows.table();
}

DataTable view_table(const ProfileTable& profiles) {
  RowTable rows("profile", "Share of scenarios in which " + profiles.column.info.id +
                               " is within a ratio of the best method's");
  for (const PerformanceProfile& profile : profiles.profiles) {
    rows.begin_row();
    rows.add("method", Field{profile.method});
    for (const auto& [label, ratio] :
         {std::pair{"best", 1.0}, std::pair{"1.05 x", 1.05}, std::pair{"1.1 x", 1.1},
          std::pair{"1.25 x", 1.25}, std::pair{"1.5 x", 1.5}, std::pair{"2 x", 2.0},
          std::pair{"5 x", 5.0}}) {
      rows.add(label, std::optional(share_at(profile, ratio)));
    }
    rows.add("no value", profile.without_value);
  }
  return rows.table();
}

class ProfileInterpreter : public Interpreter {
 public:
  std::string id() const override { return "profile"; }
  std::string help() const override {
    return "Say how often each method is how near to the best: performance profiles";
  }
  std::vector<std::string> default_metrics() const override { return {"time_to_goal"}; }
  Interpretation interpret(const std::vector<RunColumns>& results,
                           const Question& question) const override {
    Interpretation found;
    for (const std::string& metric : question.metrics) {
      const ProfileTable profiles = build_profiles(results[0], metric);
      found.tables.push_back(steps_table(profiles));
      found.views.push_back(view_table(profiles));
    }
    return found;
  }
};

}  // namespace

std::unique_ptr<Interpreter> make_profile_interpreter() {
  return std::make_unique<ProfileInterpreter>();
}

}  // namespace slalom
