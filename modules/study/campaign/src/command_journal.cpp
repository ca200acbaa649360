// SPDX-License-Identifier: BSD-3-Clause
#include "command_journal.h"

#include <slalom/methods/registry.h>

#include <array>
#include <cmath>
#include <cstring>

namespace slalom {
namespace {

using Entry = std::array<double, 3>;

}  // namespace

void CommandJournal::on_cycle(const Observation&, const Command& command,
                              const mrpt::math::TPose2D&) {
  const Entry entry = {command.v, command.w, command.vy};
  log_.append(entry.data(), sizeof entry);
  log_.heartbeat();
}

std::size_t CommandJournal::size_for(const SimulationOptions& options) {
  const double cycles =
      std::ceil(options.max_time ? *options.max_time / options.control_period : kMaxAutoCycles) + 2;
  return static_cast<std::size_t>(cycles) * sizeof(Entry);
}

std::vector<Command> CommandJournal::read(const std::string& log, const RobotModel& robot) {
  std::vector<Command> commands;
  for (std::size_t at = 0; at + sizeof(Entry) <= log.size(); at += sizeof(Entry)) {
    Entry entry;
    std::memcpy(entry.data(), log.data() + at, sizeof entry);
    const Command command{entry[0], entry[1], entry[2]};
    std::string reason;
    if (!is_valid_command(command, robot, reason)) break;
    commands.push_back(command);
  }
  return commands;
}

}  // namespace slalom
