// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/bags/bag_info.h>

#include <iostream>

namespace slalom {
namespace {

struct InfoArguments {
  std::string bag;
  bool json = false;
};

void print_info(const InfoArguments& arguments) {
  const BagInfo info = read_bag_info(arguments.bag);
  std::cout << (arguments.json ? render_json(info) + "\n" : render_text(info));
}

}  // namespace

void define_info(CLI::App& app) {
  static InfoArguments arguments;
  CLI::App* verb = app.add_subcommand("info", "List the topics and frames of a bag of ROS");
  verb->add_option("bag", arguments.bag,
                   "Bag of ROS 1 (.bag) or ROS 2 (.mcap, .db3, or its folder)")
      ->required();
  verb->add_flag("--json", arguments.json, "Print one JSON object");
  verb->callback([] { print_info(arguments); });
}

}  // namespace slalom
