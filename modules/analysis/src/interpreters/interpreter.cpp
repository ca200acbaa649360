#include "interpreters.h"

namespace slalom {

std::vector<std::unique_ptr<Interpreter>> all_interpreters() {
  std::vector<std::unique_ptr<Interpreter>> all;
  all.push_back(make_summary_interpreter());
  all.push_back(make_cross_table_interpreter());
  all.push_back(make_map_interpreter());
  all.push_back(make_comparison_interpreter());
  all.push_back(make_ranks_interpreter());
  all.push_back(make_profile_interpreter());
  all.push_back(make_completion_interpreter());
  all.push_back(make_failure_interpreter());
  all.push_back(make_validity_interpreter());
  all.push_back(make_robustness_interpreter());
  return all;
}

}  // namespace slalom
