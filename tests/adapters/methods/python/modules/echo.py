# SPDX-License-Identifier: BSD-3-Clause
"""Methods for python_method_test.cpp."""

import helper  # a module of the same folder


class Echo:
    """Commands that contain what the method was given."""

    options = {
        "answer": ("time", "-", "what step() returns"),
        "gain": (1.5, "1/s", "a number"),
        "count": (3, "-", "an integer"),
        "enabled": (False, "-", "a truth value"),
    }

    def __init__(self, robot, options):
        self.robot, self.options = robot, options
        self.outcome = ""
        if options.gain < 0:
            raise ValueError("negative gain")

    def reset(self, task):
        self.task = task

    def step(self, o):
        robot, task, options = self.robot, self.task, self.options
        return {
            "time": lambda: (o.time, o.phi),
            "pose": lambda: (o.x, o.y),
            "velocity": lambda: (o.v, o.w, o.vy),
            "goal": lambda: (o.goal_x, o.goal_y),
            "ranges": lambda: (float(o.ranges[0]), float(o.ranges[-1]), len(o.ranges)),
            "dtype": lambda: (o.ranges.dtype == "float32", o.ranges.flags.writeable),
            "start": lambda: (task.start_x, task.start_y, task.start_phi),
            "task": lambda: (task.goal_x, task.goal_y, task.goal_tolerance),
            "heading": lambda: (task.goal_heading, task.goal_heading_tolerance),
            "period": lambda: (task.control_period, task.seed),
            "limits": lambda: (robot.max_v, robot.max_w, robot.radius),
            "accelerations": lambda: (robot.max_accel_v, robot.max_accel_w),
            "sensor": lambda: (robot.rays, robot.aperture, robot.max_range),
            "shape": lambda: (len(robot.footprint), robot.holonomic, robot.forward_only),
            "corner": lambda: robot.footprint[0],
            "options": lambda: (options.gain, options.count, options.enabled),
            "list": lambda: [0.5, 0.25],
            "one": lambda: (1.0,),
            "four": lambda: (1, 2, 3, 4),
            "none": lambda: None,
            "text": lambda: "go",
            "words": lambda: ("go", "left"),
            "hash": lambda: (hash("slalom") % 1000, hash("words") % 1000),
            "helper": lambda: helper.command(),
            "raise": lambda: helper.fail(),
            "exit": lambda: exit(3),
            "write": lambda: o.ranges.fill(0),
        }[options.answer]()


class OnlyStep:
    options = {"turn": (1.0, "rad/s", "more in each step")}
    steps = 0

    def step(self, o):
        self.steps += 1
        return self.robot.max_v, self.steps * self.options.turn


class NoStep:
    def reset(self, task):
        pass


class BadOptions:
    options = {"gain": 1.5}

    def reset(self, task):
        pass

    def step(self, observation):
        return 0, 0


class Mapper:
    """Commands that contain the map."""

    uses_map = True

    def __init__(self, robot, options):
        pass

    def reset(self, task):
        self.map = task.map

    def step(self, o):
        rows, columns = self.map.cells.shape
        return rows + 10 * columns + 100 * self.map.cells[1, 2], self.map.resolution, self.map.origin_y


class Tracker:
    """Commands that contain the tracks of movers."""

    uses_tracks = True

    def __init__(self, robot, options):
        pass

    def reset(self, task):
        pass

    def step(self, o):
        t = o.tracks[-1]
        return len(o.tracks) + t.id, t.x + 10 * t.y, t.vx + 10 * t.vy + 100 * t.radius
