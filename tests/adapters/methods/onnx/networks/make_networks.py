#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the networks of onnx_method_test.cpp: linear layers with the weights that it states."""

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper


def save(name, inputs, nodes, constants, outputs):
    graph = helper.make_graph(
        nodes,
        name,
        [helper.make_tensor_value_info(key, TensorProto.FLOAT, shape) for key, shape in inputs.items()],
        [helper.make_tensor_value_info("output", TensorProto.FLOAT, [1, outputs])],
        [numpy_helper.from_array(np.ascontiguousarray(value, dtype=np.float32), key) for key, value in constants.items()],
    )
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 11)], producer_name="slalom")
    model.ir_version = 7
    onnx.checker.check_model(model)
    onnx.save(model, name + ".onnx")


def linear(name, weights):
    rows, columns = np.shape(weights)
    nodes = [helper.make_node("Gemm", ["input", "weights", "bias"], ["output"], transB=1)]
    save(name, {"input": [1, rows]}, nodes, {"weights": np.transpose(weights), "bias": np.zeros(columns)}, columns)


def named(name, weights):
    nodes = [
        helper.make_node("Flatten", ["scan"], ["flat"], axis=1),
        helper.make_node("Concat", ["flat", "state"], ["all"], axis=1),
        helper.make_node("Gemm", ["all", "weights", "bias"], ["output"], transB=1),
    ]
    save(name, {"scan": [1, 1, 4], "state": [1, 5]}, nodes, {"weights": np.transpose(weights), "bias": [0, 0]}, 2)


linear("linear", [[2**i, i] for i in range(8)])
linear("holonomic", [[2**i, i, -i] for i in range(9)])
named("named", [[2**i, i] for i in range(9)])
