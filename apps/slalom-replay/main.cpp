// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/program.h>

namespace slalom {
namespace {

void define(CLI::App& app) {
  define_play(app);
  define_check(app);
  define_metrics(app);
  define_openloop(app);
  define_identify(app);
  define_info(app);
  define_import(app);
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program(
      "slalom-replay",
      "Replays recorded runs; runs methods on rawlogs and bags, and estimates robots from them.",
      argc, argv, slalom::define);
}
