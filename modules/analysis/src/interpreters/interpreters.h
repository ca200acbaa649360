#pragma once

#include <slalom/analysis/interpreter.h>

#include <memory>

namespace slalom {

std::unique_ptr<Interpreter> make_comparison_interpreter();
std::unique_ptr<Interpreter> make_completion_interpreter();
std::unique_ptr<Interpreter> make_cross_table_interpreter();
std::unique_ptr<Interpreter> make_failure_interpreter();
std::unique_ptr<Interpreter> make_map_interpreter();
std::unique_ptr<Interpreter> make_profile_interpreter();
std::unique_ptr<Interpreter> make_ranks_interpreter();
std::unique_ptr<Interpreter> make_robustness_interpreter();
std::unique_ptr<Interpreter> make_summary_interpreter();
std::unique_ptr<Interpreter> make_validity_interpreter();

}  // namespace slalom
