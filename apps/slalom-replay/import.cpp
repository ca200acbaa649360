// SPDX-License-Identifier: BSD-3-Clause
#include "bag_options.h"
#include "verbs.h"

#include <slalom/core/text.h>

#include <iostream>

namespace slalom {
namespace {

struct ImportArguments {
  std::string bag, output;
  BagSelection selection;
};

void convert(const ImportArguments& arguments) {
  const LogObjects log = import_bag(arguments.bag, arguments.selection);
  print_notes(log);
  write_rawlog(log, arguments.output);
  std::cout << arguments.output << ": " << count_text(log.objects.size(), "observation") << "\n";
}

}  // namespace

void define_import(CLI::App& app) {
  static ImportArguments arguments;
  CLI::App* verb = app.add_subcommand("import", "Convert a bag of ROS to a rawlog");
  verb->add_option("bag", arguments.bag,
                   "Bag of ROS 1 (.bag) or ROS 2 (.mcap, .db3, or its folder)")
      ->required();
  verb->add_option("-o,--output", arguments.output, "The rawlog to write")->required();
  add_bag_options(*verb, arguments.selection);
  verb->callback([] { convert(arguments); });
}

}  // namespace slalom
