// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/evaluate.h>

#include <pybind11/pybind11.h>
#include <string>

namespace slalom {

/// Keyword arguments as sections of an .ini: {"robot": {"radius": 0.3}}. Values are numbers, truth
/// values, texts, or lists of these or of points. Throws Error (Usage) for others.
IniFile to_ini(const pybind11::dict& sections);

/// Reads the sections robot, sensor, odometry, simulation, limits and tracks. Throws Error (Usage).
Options read_evaluate_options(const IniFile& ini);

/// The methods by name: a class, (class, {option: value}), or {key: value} as in an .ini. Throws
/// Error (Usage).
Methods to_methods(const pybind11::dict& methods);

}  // namespace slalom
