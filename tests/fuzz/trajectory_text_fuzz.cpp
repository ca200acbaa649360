// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/io/trajectory_file.h>

#include <algorithm>
#include <cmath>

/// Trajectory logs as CSV or TUM. A first line that begins with "columns:" is --columns.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  std::string text = fuzz::text_of(data, size);
  LogSelection selection;
  if (text.compare(0, 8, "columns:") == 0) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    selection.columns = text.substr(8, end - 8);
    text.erase(0, end);
  }
  if (text.compare(0, 5, "1 0 0") == 0) selection.rate = 10;  // poses of KITTI
  for (const bool lateral : {false, true})
    fuzz::read_or_refuse([&] {
      for (const auto& run : trajectory_runs_from_text(text, "input", lateral, selection))
        fuzz::expect(run.trajectory.samples.size() >= 2, "a run has two samples or more");
      const auto log = trajectory_from_text(text, "input", lateral, selection);
      fuzz::expect(log.trajectory.samples.size() >= 2, "a trajectory has two samples or more");
      for (const Sample& sample : log.trajectory.samples)
        fuzz::expect(std::isfinite(sample.t) && std::isfinite(sample.pose.phi),
                     "times and headings are finite");
    });
  return 0;
}
