#!/usr/bin/env python3
"""Trains a small navigation policy by imitation and writes it as policy.onnx.

The teacher is a trajectory rollout on the current scan. The network sees what adapter = onnx gives it with
policy.ini: 61 values of the scan, the goal and the velocity. After the first round it drives itself, and the teacher
says what it would have done (DAgger: Ross, Gordon, Bagnell, AISTATS 2011).

    python3 train.py [-o policy.onnx] [--scenarios 60] [--rounds 6] [--epochs 30]
"""

import argparse

import numpy as np
import onnx
import slalom
from onnx import TensorProto, helper, numpy_helper

SCAN = 61  # values of the scan
GOAL_DISTANCE = 10.0  # m


class Encoder:
    """The inputs of the network, as adapter = onnx makes them from [sensor] and [robot]."""

    def __init__(self, robot):
        self.robot = robot
        rays = robot.rays
        self.groups = [slice(i * rays // SCAN, (i + 1) * rays // SCAN) for i in range(SCAN)]

    def __call__(self, observation):
        ranges = np.minimum(observation.ranges, self.robot.max_range)
        scan = [ranges[group].min() / self.robot.max_range for group in self.groups]
        bearing = np.arctan2(observation.goal_y, observation.goal_x)
        distance = np.hypot(observation.goal_x, observation.goal_y)
        goal = [min(1.0, distance / GOAL_DISTANCE), np.cos(bearing), np.sin(bearing)]
        velocity = [observation.v / self.robot.max_v, observation.w / self.robot.max_w]
        return np.array(scan + goal + velocity, dtype=np.float32)


class Teacher:
    """Chooses the free direction nearest to the goal, and the arc that leads there with clearance."""

    HORIZON, STEPS = 1.6, 8  # s
    MARGIN, COMFORT = 0.05, 0.35  # m
    LOOK_AHEAD = 1.5  # m

    def __init__(self, robot):
        self.robot = robot
        self.angles = np.linspace(-robot.aperture / 2, robot.aperture / 2, robot.rays)
        self.rays = np.stack([np.cos(self.angles), np.sin(self.angles)])
        between = self.angles[:, None] - self.angles  # of a direction and a ray
        self.cos, self.sin = np.cos(between), np.abs(np.sin(between))
        v, w = np.meshgrid(np.linspace(0, robot.max_v, 6), np.linspace(-robot.max_w, robot.max_w, 13))
        self.v, self.w = v.ravel(), w.ravel()
        t = np.linspace(self.HORIZON / self.STEPS, self.HORIZON, self.STEPS)
        turned = np.outer(self.w, t)
        chord = np.outer(self.v, t) * np.sinc(turned / (2 * np.pi))
        self.x, self.y = chord * np.cos(turned / 2), chord * np.sin(turned / 2)
        self.end = turned[:, -1]

    def command(self, observation):
        bearing = np.arctan2(observation.goal_y, observation.goal_x)
        if abs(bearing) > self.robot.aperture / 2:  # behind
            return 0.0, np.copysign(self.robot.max_w, bearing)
        distance = np.hypot(observation.goal_x, observation.goal_y)
        free = self.free_lengths(observation.ranges)
        reach = min(distance, self.LOOK_AHEAD)
        open_ones = np.flatnonzero(free >= reach)
        if len(open_ones) == 0:
            left, right = free[self.angles > 0].mean(), free[self.angles < 0].mean()
            return 0.0, np.copysign(self.robot.max_w, left - right)
        direction = self.angles[open_ones[np.argmin(np.abs(self.angles[open_ones] - bearing))]]
        return self.arc(observation.ranges, reach * np.cos(direction), reach * np.sin(direction))

    def free_lengths(self, ranges):
        """How far the robot can go straight in the direction of each ray, m."""
        width = self.robot.radius + self.MARGIN
        aside = self.sin * ranges
        blocked = (aside < width) & (self.cos > 0) & (ranges < self.robot.max_range)
        length = self.cos * ranges - np.sqrt(np.maximum(width**2 - aside**2, 0))
        return np.where(blocked, length, self.robot.max_range).min(axis=1)

    def arc(self, ranges, x, y):
        near = ranges < min(self.robot.max_range, 3.0)
        obstacles = self.rays[:, near] * ranges[near]
        to_obstacles = np.hypot(self.x[:, :, None] - obstacles[0], self.y[:, :, None] - obstacles[1])
        clearance = to_obstacles.min(axis=(1, 2), initial=9.0) - self.robot.radius
        closest = np.hypot(self.x - x, self.y - y).min(axis=1)
        error = np.arctan2(y - self.y[:, 0], x - self.x[:, 0]) - self.w * self.HORIZON / self.STEPS
        cost = (
            closest
            + 0.2 * np.abs(np.arctan2(np.sin(error), np.cos(error)))
            + 0.8 * np.clip(1 - clearance / self.COMFORT, 0, None)
            + np.where((clearance < self.MARGIN) & (self.v > 0), 10.0, 0)
        )
        best = np.argmin(cost)
        return self.v[best], self.w[best]


class Network:
    """A perceptron with two hidden layers and tanh at its output."""

    def __init__(self, random, hidden=64):
        sizes = [SCAN + 5, hidden, hidden, 2]
        self.weights = [random.normal(0, np.sqrt(2 / a), (a, b)).astype(np.float32) for a, b in zip(sizes, sizes[1:])]
        self.biases = [np.zeros(b, dtype=np.float32) for b in sizes[1:]]

    def layers(self, x):
        activations = [x]
        for weights, bias in zip(self.weights[:-1], self.biases[:-1]):
            activations.append(np.maximum(activations[-1] @ weights + bias, 0))
        activations.append(np.tanh(activations[-1] @ self.weights[-1] + self.biases[-1]))
        return activations

    def train(self, inputs, targets, epochs, random, rate=1e-3, batch=256):
        """Adam (Kingma and Ba, ICLR 2015) on the mean squared error."""
        parameters = self.weights + self.biases
        first = [np.zeros_like(p) for p in parameters]
        second = [np.zeros_like(p) for p in parameters]
        step = 0
        for _ in range(epochs):
            order = random.permutation(len(inputs))
            for start in range(0, len(order), batch):
                part = order[start : start + batch]
                step += 1
                for p, m, s, g in zip(parameters, first, second, self.gradients(inputs[part], targets[part])):
                    m += 0.1 * (g - m)
                    s += 0.001 * (g * g - s)
                    p -= rate * (m / (1 - 0.9**step)) / (np.sqrt(s / (1 - 0.999**step)) + 1e-8)

    def gradients(self, inputs, targets):
        activations = self.layers(inputs)
        error = 2 * (activations[-1] - targets) / len(inputs) * (1 - activations[-1] ** 2)
        weights, biases = [], []
        for layer in reversed(range(len(self.weights))):
            weights.insert(0, activations[layer].T @ error)
            biases.insert(0, error.sum(axis=0))
            error = (error @ self.weights[layer].T) * (activations[layer] > 0)
        return weights + biases

    def save(self, path):
        nodes, constants, last = [], [], "input"
        for i, (weights, bias) in enumerate(zip(self.weights, self.biases)):
            constants.append(numpy_helper.from_array(np.ascontiguousarray(weights.T), f"weights{i}"))
            constants.append(numpy_helper.from_array(bias, f"bias{i}"))
            is_last = i + 1 == len(self.weights)
            nodes.append(helper.make_node("Gemm", [last, f"weights{i}", f"bias{i}"], [f"sum{i}"], transB=1))
            last = "output" if is_last else f"hidden{i}"
            nodes.append(helper.make_node("Tanh" if is_last else "Relu", [f"sum{i}"], [last]))
        graph = helper.make_graph(
            nodes,
            "policy",
            [helper.make_tensor_value_info("input", TensorProto.FLOAT, [1, SCAN + 5])],
            [helper.make_tensor_value_info("output", TensorProto.FLOAT, [1, 2])],
            constants,
        )
        model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 11)], producer_name="slalom")
        model.ir_version = 7
        onnx.checker.check_model(model)
        onnx.save(model, path)


class Collector:
    """A method that drives by the teacher, or by a network, and notes what the teacher would do."""

    inputs, targets, network = [], [], None

    def __init__(self, robot, options):
        self.robot, self.encode, self.teacher = robot, Encoder(robot), Teacher(robot)

    def reset(self, task):
        pass

    def step(self, observation):
        features = self.encode(observation)
        v, w = self.teacher.command(observation)
        Collector.inputs.append(features)
        Collector.targets.append((v / self.robot.max_v, w / self.robot.max_w))
        if Collector.network is not None:
            v, w = Collector.network.layers(features)[-1].astype(float) * (self.robot.max_v, self.robot.max_w)
        return max(0.0, v), w


def main():
    parser = argparse.ArgumentParser(description="Trains a small navigation policy and writes it as an .onnx file.")
    parser.add_argument("-o", "--output", default="policy.onnx")
    parser.add_argument("--scenarios", type=int, default=60, help="new ones in each round")
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--epochs", type=int, default=30)
    arguments = parser.parse_args()
    random = np.random.default_rng(1)
    network = Network(random)
    for number in range(arguments.rounds):
        scenarios = slalom.generate("random", count=arguments.scenarios, seed=100 + number)
        results = slalom.evaluate(
            {"policy": Collector},
            scenarios,
            simulation={"max_time": 30},
            metrics=["success"],
            descriptors=["density"],
            in_process=True,
        )
        inputs, targets = np.array(Collector.inputs), np.array(Collector.targets, dtype=np.float32)
        network.train(inputs, targets, arguments.epochs, random)
        Collector.network = network
        who = "teacher" if number == 0 else "network"
        print(f"round {number + 1}: {who} succeeds in {np.mean(results['success']):.2f}, {len(inputs)} samples")
    network.save(arguments.output)
    print(f"{arguments.output}: {sum(p.size for p in network.weights + network.biases)} parameters")


if __name__ == "__main__":
    main()
