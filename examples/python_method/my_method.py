"""An avoidance method in Python: turns to the free direction closest to the goal."""

import math

import numpy as np


class MyMethod:
    # Keys of the .ini section: default, unit, help.
    options = {"look_ahead": (1.2, "m", "free distance that a direction must have")}

    def __init__(self, robot, options):
        self.robot = robot
        self.look_ahead = options.look_ahead
        self.angles = np.linspace(-robot.aperture / 2, robot.aperture / 2, robot.rays)

    def reset(self, task):
        pass  # a method with state clears it here

    def step(self, observation):
        goal = math.atan2(observation.goal_y, observation.goal_x)
        needed = min(self.look_ahead, math.hypot(observation.goal_x, observation.goal_y))
        free = [
            direction
            for direction in self.angles[::4]
            if self.free_distance(observation.ranges, direction) >= needed
        ]
        if not free:
            return 0.0, self.robot.max_w / 2
        direction = min(free, key=lambda angle: abs(angle - goal))
        ahead = self.free_distance(observation.ranges, 0.0) - 0.1
        v = np.clip(ahead, 0, self.robot.max_v) * max(0.0, math.cos(direction))
        return v, np.clip(2 * direction, -self.robot.max_w, self.robot.max_w)

    def free_distance(self, ranges, direction):
        """Free distance of the robot straight in a direction, m."""
        angles = self.angles - direction
        hit = (np.cos(angles) > 0) & (
            np.abs(ranges * np.sin(angles)) < self.robot.radius + 0.1
        )
        distances = ranges[hit] * np.cos(angles[hit])
        return min(self.robot.max_range, distances.min(initial=math.inf)) - self.robot.radius
