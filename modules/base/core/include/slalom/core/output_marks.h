// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace slalom {

/// Lines of the output of a method around what its processes print while they are being ended.
constexpr char kEndingOutput[] = "-- the processes are being ended\n";
constexpr char kEndedOutput[] = "-- the processes have ended\n";

}  // namespace slalom
