# SPDX-License-Identifier: BSD-3-Clause
"""Methods that set parameters of others, and whose parameters are set."""


class Tuner:
    options = {"factor": (0.25, "1/m", "gain per meter to the goal")}

    def adapt(self, observation):
        return {"gain": self.options.factor * observation.goal_x, "count": 3.0, "fast": True, "mode": "b"}


class NoParameters:
    def adapt(self, observation):
        return 0.5


class Gain:
    options = {"gain": (1.0, "-", "v"), "count": (1, "-", "w"), "fast": (False, "-", "vy")}

    def step(self, observation):
        return self.options.gain, self.options.count, self.options.fast


class Copying(Gain):
    """Has a constructor that does not keep its options."""

    def __init__(self, robot, options):
        self.gain = options.gain

    def step(self, observation):
        return self.gain, 0


class Taking(Copying):
    def set_parameter(self, name, value):
        setattr(self, name, value + 1)
