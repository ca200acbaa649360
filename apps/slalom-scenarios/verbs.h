// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>
#include <slalom/scenario/scenario.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace slalom {

/// One function per group of verbs: adds them with their options and callbacks.
void add_creation_verbs(CLI::App& app);  ///< generate, import
void add_show_verbs(CLI::App& app);      ///< list, show, render
void add_describe_verb(CLI::App& app);   ///< describe
void add_select_verbs(CLI::App& app);    ///< select, copy, move, delete, restore
void add_lists_verbs(CLI::App& app);     ///< create, merge, dedupe, split
void add_edit_verbs(CLI::App& app);      ///< tag, rename, movers
void add_index_verbs(CLI::App& app);     ///< index create, drop, list, show
void add_convert_verbs(CLI::App& app);   ///< convert, export
void add_reference_verb(CLI::App& app);  ///< reference

/// Common arguments of the verbs that read one list.
struct ListArguments {
  std::string list;
  std::string id;  ///< empty for all
  bool json = false;
  double robot_radius = 0.25, resolution = 0.05, sensor_range = 8;
};

CLI::App* add_list_verb(CLI::App& app, const std::string& name, const std::string& help,
                        ListArguments& arguments);
/// Adds a scenario of the list as a second argument or as --id.
void add_scenario_argument(CLI::App& verb, ListArguments& arguments, bool required = true);
void add_robot_options(CLI::App& verb, ListArguments& arguments);

/// Throws Error (Usage) for another name than one in .png or .svg.
void require_picture(const std::string& path);
/// Draws a scenario with its reference paths into a file of which require_picture() holds.
void write_picture(const Scenario& scenario, const References& references, double robot_radius,
                   int pixels, const std::string& path);

}  // namespace slalom
