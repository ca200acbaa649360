"""Turns to the free direction closest to the goal."""

import math

import numpy as np


class MyMethod:
    options = {"margin": (0.0, "m", "kept free on each side of the robot")}

    def __init__(self, robot, options):
        self.robot, self.width = robot, robot.radius + options.margin
        last = robot.rays - 1
        self.angles = [robot.aperture * (i / last - 0.5) for i in range(robot.rays)]
        self.cos = np.array([math.cos(angle) for angle in self.angles])
        self.sin = np.array([math.sin(angle) for angle in self.angles])

    def reset(self, task):
        pass  # a method with memory clears it here

    def step(self, observation):
        x, y = observation.ranges * self.cos, observation.ranges * self.sin
        goal = math.atan2(observation.goal_y, observation.goal_x)
        needed = min(1.0, math.hypot(observation.goal_x, observation.goal_y))
        best = None
        for i in range(0, self.robot.rays, 4):
            if best is not None and abs(self.angles[i] - goal) >= abs(best - goal):
                continue
            if self.free(x, y, self.cos[i], self.sin[i]) >= needed:
                best = self.angles[i]
        if best is None:
            return 0.0, self.robot.max_w / 2
        v = min(self.free(x, y, 1.0, 0.0), self.robot.max_v) * max(0.0, 1 - abs(best))
        return max(0.0, v), min(max(2 * best, -self.robot.max_w), self.robot.max_w)

    def free(self, x, y, cos, sin):
        """Free distance (m) of the robot in a direction, among obstacles at x and y."""
        ahead, side = x * cos + y * sin, y * cos - x * sin
        hit = (ahead > 0) & (np.abs(side) < self.width)
        return ahead[hit].min(initial=self.robot.max_range) - self.width
