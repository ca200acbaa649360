// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/mover.h>

#include <string>

namespace slalom {

struct MoversFileOptions {
  double radius = 0.3;    ///< m, of movers without one in the file
  double begin = 0;       ///< s, the time in the file at which a run begins
  double frame_rate = 0;  ///< frames per second, of files with frames; 0: unknown
};

/// Reads positions of people or robots over time, detected from the first line, as movers that are
/// present from their first position to their last one:
///
/// - CSV with a header line: id, t, x, y and optionally r, in any order; t in s, others in m. With
///   a column `frame` in place of t, the frame rate is needed; vx and vy (m/s) check it. The
///   columns type and label are ignored, and the ending "_est", as of CITR and DUT (Yang et al.
///   2019). `time` is t; `track_id`, `person`, `ped_id` and the like are id.
/// - Four numbers a line: frame, id, x and y, as prediction benchmarks distribute them (Social GAN,
///   TrajNet).
/// - `obsmat.txt` of the ETH data set (Pellegrini et al. 2009, "You'll never walk alone"), also in
///   use for UCY: eight numbers a line, of which the frame, the id and the positions in m (third
///   and fifth) are used. The velocities in m/s (sixth and eighth) check the frame rate.
/// - `agents.yaml` of HuNavSim: no positions over time, but goals, over which each agent walks
///   straight at its `max_vel`, from its `init_pose` on, in a loop over that if the goals are
///   cyclic. Behaviors and social forces are left out; `begin` must be 0.
///
/// A line "# framerate: 25" before the positions, as of the data archive of Juelich, states the
/// frame rate.
///
/// Times before `begin` are dropped; the position at `begin` is interpolated. Lines that are empty
/// or begin with '#' are ignored. Ids are those of the file, in its order.
///
/// Throws Error (File) with line and what was expected for: non-finite numbers, times of an id that
/// do not increase, different radii of an id, unknown, duplicate or missing columns, more than a
/// million lines, movers that check_movers() refuses, no position at or after `begin`, frames
/// without a frame rate, with another one than the file states or one that contradicts the
/// velocities by more than a quarter, frames
/// with a median speed above 5 m/s (pixels), and what read_file() refuses.
Movers load_movers_file(const std::string& path, const MoversFileOptions& options = {});
Movers movers_from_text(const std::string& text, const std::string& where,
                        const MoversFileOptions& options = {});

}  // namespace slalom
