// SPDX-License-Identifier: BSD-3-Clause
#include "interpreter.h"
#include "python_class.h"

#include <slalom/core/error.h>
#include <slalom/methods/registry.h>
#include <slalom/python/python_method.h>

#include <pybind11/numpy.h>
#include <system_error>

namespace slalom {
namespace {

namespace py = pybind11;

/// The robot and its sensor, with the names of slalom_method.h.
py::object describe_robot(const RobotModel& robot, const SensorModel& sensor) {
  const Footprint footprint = robot.shape();
  py::list corners;
  for (const auto& corner : footprint.hull()) corners.append(py::make_tuple(corner.x, corner.y));
  return py::module_::import("types").attr("SimpleNamespace")(
      py::arg("radius") = robot.radius, py::arg("footprint") = corners,
      py::arg("holonomic") = robot.holonomic(), py::arg("forward_only") = robot.forward_only,
      py::arg("max_v") = robot.max_v, py::arg("max_w") = robot.max_w,
      py::arg("max_accel_v") = robot.max_accel_v, py::arg("max_accel_w") = robot.max_accel_w,
      py::arg("rays") = sensor.rays, py::arg("aperture") = sensor.aperture(),
      py::arg("max_range") = sensor.max_range);
}

/// Ranges of the current scan. Python has a view of them, which later scans overwrite.
class Ranges {
 public:
  py::object set(const mrpt::obs::CObservation2DRangeScan& scan) {
    const std::size_t count = scan.getScanSize();
    if (!array_ || static_cast<std::size_t>(array_.size()) != count) {
      array_ = py::array_t<float>(static_cast<py::ssize_t>(count));
      data_ = array_.mutable_data();
      py::setattr(array_.attr("flags"), "writeable", py::bool_(false));
    }
    for (std::size_t i = 0; i < count; ++i) data_[i] = scan.getScanRange(i);
    return array_;
  }

 private:
  py::array_t<float> array_ = py::reinterpret_steal<py::array_t<float>>(nullptr);
  float* data_ = nullptr;
};

/// Names of attributes, made once.
struct Names {
  py::str time{"time"}, x{"x"}, y{"y"}, phi{"phi"}, v{"v"}, vy{"vy"}, w{"w"}, goal_x{"goal_x"},
      goal_y{"goal_y"}, ranges{"ranges"}, tracks{"tracks"};
};

/// The objects of Python that belong to a method. Made, used and destroyed by a thread that holds
/// the interpreter's lock.
class PythonObject {
 public:
  explicit PythonObject(const py::object& object)
      : object_(object),
        reset_(object.attr("reset")),
        step_(py::getattr(object, "step", py::none())),
        adapt_(py::getattr(object, "adapt", py::none())),
        finish_(py::getattr(object, "finish", py::none())),
        uses_tracks_(declares(object, "uses_tracks")),
        uses_map_(declares(object, "uses_map")),
        make_namespace_(py::module_::import("types").attr("SimpleNamespace")) {}

  void reset(const NavigationTask& task) {
    const py::object input = make_namespace_(
        py::arg("start_x") = task.start.x, py::arg("start_y") = task.start.y,
        py::arg("start_phi") = task.start.phi, py::arg("goal_x") = task.goal.x,
        py::arg("goal_y") = task.goal.y, py::arg("goal_tolerance") = task.goal_tolerance,
        py::arg("goal_heading") =
            task.goal_heading ? py::object(py::float_(*task.goal_heading)) : py::none(),
        py::arg("goal_heading_tolerance") = task.goal_heading_tolerance,
        py::arg("control_period") = task.control_period, py::arg("seed") = task.seed);
    if (uses_map_) py::setattr(input, "map", python_map(map_of(task)));
    reset_(input);
  }

  Command step(const Observation& observation) { return to_command(step_(seen(observation))); }

  bool adapts() const { return !adapt_.is_none(); }
  std::map<std::string, std::string> adapt(const Observation& observation) {
    return parameters_of(adapt_(seen(observation)));
  }
  void set_parameter(const std::string& name, const std::string& value) {
    set_class_parameter(object_, name, value);
  }

  bool uses_tracks() const { return uses_tracks_; }
  bool uses_map() const { return uses_map_; }

  void finish(const std::string& outcome) {
    if (!finish_.is_none()) finish_(outcome);
  }

 private:
  py::object seen(const Observation& observation) {
    const py::object input = make_namespace_();
    const auto set = [&](const py::str& name, double value) {
      py::setattr(input, name, py::float_(value));
    };
    set(names_.time, observation.time);
    set(names_.x, observation.odometry.x);
    set(names_.y, observation.odometry.y);
    set(names_.phi, observation.odometry.phi);
    set(names_.v, observation.v);
    set(names_.vy, observation.vy);
    set(names_.w, observation.w);
    set(names_.goal_x, observation.goal_in_robot.x);
    set(names_.goal_y, observation.goal_in_robot.y);
    py::setattr(input, names_.ranges, ranges_.set(*observation.scan));
    if (uses_tracks_) py::setattr(input, names_.tracks, python_tracks(tracks_of(observation)));
    return input;
  }

  static bool declares(const py::object& object, const char* attribute) {
    return py::bool_(py::getattr(object, attribute, py::bool_(false)));
  }

  py::object python_map(const KnownMap& map) const {
    const py::array_t<std::uint8_t> cells({map.size_y, map.size_x}, map.cells->data());  // a copy
    return make_namespace_(py::arg("resolution") = map.resolution,
                           py::arg("origin_x") = map.origin.x, py::arg("origin_y") = map.origin.y,
                           py::arg("cells") = cells);
  }

  py::list python_tracks(const std::vector<Track>& tracks) const {
    py::list result;
    for (const Track& track : tracks)
      result.append(
          make_namespace_(py::arg("id") = track.id, py::arg("x") = track.position.x,
                          py::arg("y") = track.position.y, py::arg("vx") = track.velocity.x,
                          py::arg("vy") = track.velocity.y, py::arg("radius") = track.radius));
    return result;
  }

  static Command to_command(const py::object& output) {
    const bool sequence = PySequence_Check(output.ptr()) != 0 && !py::isinstance<py::str>(output);
    const std::size_t size = sequence ? py::len(output) : 0;
    Command command;
    try {
      if (size != 2 && size != 3) throw py::cast_error("size");
      command.v = output[py::int_(0)].cast<double>();
      command.w = output[py::int_(1)].cast<double>();
      if (size == 3) command.vy = output[py::int_(2)].cast<double>();
    } catch (const py::cast_error&) {
      throw MethodError("step() returned " + std::string(py::repr(output)) +
                        "; expected (v, w) or (v, w, vy)");
    }
    return command;
  }

  py::object object_, reset_, step_, adapt_, finish_;
  bool uses_tracks_, uses_map_;
  py::object make_namespace_;
  Names names_;
  Ranges ranges_;
};

class PythonMethod : public Method {
 public:
  /// The caller holds the interpreter's lock.
  PythonMethod(const py::object& object, std::vector<TunableParameter> tunable)
      : object_(std::make_unique<PythonObject>(object)),
        tunable_(std::move(tunable)),
        uses_tracks_(object_->uses_tracks()),
        uses_map_(object_->uses_map()),
        adapts_(object_->adapts()) {}
  // The process ends if there is no memory for the lock.
  // NOLINTNEXTLINE(bugprone-exception-escape)
  ~PythonMethod() override {
    const py::gil_scoped_acquire lock;
    object_.reset();
  }
  PythonMethod(const PythonMethod&) = delete;
  PythonMethod& operator=(const PythonMethod&) = delete;

  bool uses_tracks() const override { return uses_tracks_; }
  bool uses_map() const override { return uses_map_; }
  std::vector<TunableParameter> tunable_parameters() const override { return tunable_; }
  void reset(const NavigationTask& task) override {
    call([&] { object_->reset(task); });
  }
  Command step(const Observation& observation) override {
    Command command;
    call([&] { command = object_->step(observation); });
    return command;
  }
  bool adapts() const override { return adapts_; }
  std::map<std::string, std::string> adapt(const Observation& observation) override {
    std::map<std::string, std::string> parameters;
    call([&] { parameters = object_->adapt(observation); });
    return parameters;
  }
  void set_parameter(const std::string& name, const std::string& value) override {
    call([&] { object_->set_parameter(name, value); });
  }
  void finish(const std::string& outcome) override {
    call([&] { object_->finish(outcome); });
  }

 private:
  template <typename Action>
  static void call(Action action) {
    const py::gil_scoped_acquire lock;
    try {
      action();
    } catch (const py::error_already_set& error) {
      throw MethodError(describe_error(error));
    } catch (const Error& error) {
      throw MethodError(error.what());
    }
  }

  std::unique_ptr<PythonObject> object_;
  std::vector<TunableParameter> tunable_;
  bool uses_tracks_, uses_map_, adapts_;
};

/// The caller holds the interpreter's lock.
std::unique_ptr<Method> create(const py::object& type, const py::object& options,
                               const std::string& where, const RobotModel& robot,
                               const SensorModel& sensor) {
  try {
    py::module_::import("numpy");
    return std::make_unique<PythonMethod>(type(describe_robot(robot, sensor), options),
                                          class_option_ranges(type, options, where));
  } catch (const py::error_already_set& error) {
    throw usage_error(where,
                      std::string(py::str(py::getattr(type, "__name__", py::str("object")))) +
                          " cannot be created: " + describe_error(error));
  }
}

std::unique_ptr<Method> load(const PythonOptions& options, const OptionLocation& where,
                             const RobotModel& robot, const SensorModel& sensor) {
  if (options.module.empty()) throw usage_error(where(""), "missing module", "module = FILE.py");
  const std::string path =
      resolve_method_file("module", options.module, options.folder, where("module"));
  try {
    start_interpreter();
  } catch (const std::runtime_error& error) {
    throw usage_error(where(""), error.what());
  }
  const py::gil_scoped_acquire lock;
  const py::object type = complete_class(
      find_class(import_module(path, where("module")), options.class_name, where("class")),
      where("class"), options.adapts);
  py::dict values;
  for (const auto& [key, text] : options.parameters) values[py::str(key)] = text;
  return create(type, make_class_options(type, values, where), where("class"), robot, sensor);
}

MethodFactory make_factory(const PythonOptions& options, const OptionLocation& where) {
  return [options, where](const RobotModel& robot, const SensorModel& sensor) {
    return load(options, where, robot, sensor);
  };
}

}  // namespace

void PythonOptions::visit(OptionVisitor& v) {
  v.option("module", module, External::Code, "file of the Python module");
  v.option("class", class_name, "class of the module, with step()");
}

MethodFactory python_method(const PythonOptions& options) {
  return make_factory(options, location_of("python_method"));
}

MethodFactory read_python_method(const IniFile& ini, const std::string& section) {
  PythonOptions options = read_parameter_options<PythonOptions>(ini, section);
  options.adapts = ini.get(section, "inner").has_value();
  return make_factory(options, location_in(ini, section));
}

}  // namespace slalom
