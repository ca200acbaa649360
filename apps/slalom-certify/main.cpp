// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/program.h>

namespace slalom {
namespace {

void define(CLI::App& app) {
  define_questions(app);
  define_show(app);
  define_verify(app);
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program("slalom-certify",
                             "States how far a method is reliable, with a confidence.", argc, argv,
                             slalom::define);
}
