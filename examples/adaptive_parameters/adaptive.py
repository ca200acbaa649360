# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of a dynamic window for open and for narrow places, chosen in each cycle."""


class ByClearance:
    # Parameters of libslalom_dwa_local_planner.so in open and in narrow places.
    options = {
        "narrow": (0.8, "m", "distance of the nearest obstacle, below which a place is narrow"),
        "sim_time_open": (1.7, "s", "simulated time of trajectories"),
        "sim_time_narrow": (1.2, "s", "the same in narrow places"),
        "occdist_scale_open": (0.01, "-", "weight of the costs of obstacles"),
        "occdist_scale_narrow": (0.01, "-", "the same in narrow places"),
        "inflation_radius_open": (0.55, "m", "distance from obstacles within which cells cost"),
        "inflation_radius_narrow": (0.4, "m", "the same in narrow places"),
    }
    option_ranges = {
        "narrow": (0.4, 2, "log"),
        "sim_time_open": (0.8, 3, "log"),
        "sim_time_narrow": (0.8, 3, "log"),
        "occdist_scale_open": (0.001, 0.3, "log"),
        "occdist_scale_narrow": (0.001, 0.3, "log"),
        "inflation_radius_open": (0.3, 1),
        "inflation_radius_narrow": (0.3, 1),
    }

    def adapt(self, observation):
        place = "narrow" if observation.ranges.min() < self.options.narrow else "open"
        names = ("sim_time", "occdist_scale", "inflation_radius")
        return {name: getattr(self.options, f"{name}_{place}") for name in names}
