// SPDX-License-Identifier: BSD-3-Clause
// navigator_runs CONFIG COUNT MAX_TIME: prints the hashes of runs, for comparison with another
// process.
#include "navigator_fixture.h"

#include <cstdlib>
#include <iostream>

int main(int count, char** arguments) {
  if (count != 4) return 2;
  const auto method = slalom::load_navigator_with(arguments[1]);
  for (const std::string& hash :
       slalom::hashes_of_runs(*method, std::atoi(arguments[2]), std::atof(arguments[3])))
    std::cout << hash << '\n';
  return 0;
}
