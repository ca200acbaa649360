// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/bags/bag_info.h>
#include <slalom/bags/bag_trajectory.h>

namespace {

using namespace slalom;

void decode(const BagMessage& message) {
  const std::string& type = message.topic.type;
  if (is_one_of(kScanTypes, type)) decode_scan(message);
  if (is_one_of(kOdometryTypes, type)) decode_odometry(message);
  if (is_one_of(kPoseTypes, type)) decode_pose(message);
  if (is_one_of(kTwistTypes, type)) decode_twist(message);
  if (is_one_of(kPathTypes, type)) decode_path(message);
  if (!is_one_of(kGridTypes, type)) return;
  const RosGrid grid = decode_grid(message);
  fuzz::expect(grid.cells.size() == std::size_t{grid.width} * grid.height, "a grid has its cells");
}

}  // namespace

/// A bag of any container; the first bytes decide which.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::InputFile file("bag", fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] { read_bag(file.path(), decode); });
  fuzz::read_or_refuse([&] {
    const BagInfo info = read_bag_info(file.path());
    fuzz::expect(!render_text(info).empty() && !render_json(info).empty(), "a bag is described");
    std::vector<std::string> moving;
    for (const auto& [name, frame] : info.frames.frames())
      fuzz::expect(info.frames.pose_in(frame.parent, name, moving).has_value(),
                   "a frame has a pose in its parent");
  });
  for (const char* topic : {"", "/odom", "/tf:base_link.laser"})
    fuzz::read_or_refuse([&] {
      const auto log = load_bag_trajectory(file.path(), topic, false);
      fuzz::expect(log.trajectory.samples.size() > 1, "a trajectory has samples");
    });
  return 0;
}
