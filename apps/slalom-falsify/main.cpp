// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/program.h>

namespace slalom {
namespace {

void define(CLI::App& app) {
  define_search(app);
  define_shrink(app);
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program("slalom-falsify",
                             "Searches scenarios in which a method fails although another method "
                             "reaches the goal, and shrinks them.",
                             argc, argv, slalom::define);
}
