// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace slalom {

/// The cores that this process may use: those of its affinity, and no more than the processor time
/// that the quotas of its control groups (cpu.max) allow, rounded up. At least one.
int available_cores();

/// `wanted` workers, or for 0 as many as there are available_cores().
int worker_count(int wanted);

/// The smallest quota of the control group `group`, such as "/user.slice/job", and those that
/// contain it, in cores, rounded up; `root` is the folder of all groups. None if there is no quota.
std::optional<int> quota_of_group(const std::string& root, const std::string& group);

}  // namespace slalom
