// SPDX-License-Identifier: BSD-3-Clause
#include "interpreter.h"

#include <slalom/core/program_path.h>

#include <Python.h>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace slalom {
namespace {

/// Environments of Python are found through the path of their interpreter. Packages of another
/// version cannot be imported.
std::string interpreter_path() {
  const char* environment = std::getenv("VIRTUAL_ENV");
  const std::filesystem::path folder = environment == nullptr ? "" : environment;
  if (folder.empty()) return SLALOM_PYTHON_EXECUTABLE;
  const std::string version =
      std::to_string(PY_MAJOR_VERSION) + "." + std::to_string(PY_MINOR_VERSION);
  std::error_code ignored;
  return std::filesystem::is_directory(folder / "lib" / ("python" + version), ignored)
             ? (folder / "bin" / "python3").string()
             : SLALOM_PYTHON_EXECUTABLE;
}

/// The standard library that is beside the programs of an archive (scripts/archive.sh), or "".
std::string bundled_home() {
  std::error_code ignored;
  const auto home = std::filesystem::path(program_folder()) / "../lib/slalom/python";
  return std::filesystem::is_directory(home / "lib", ignored) ? home.lexically_normal().string()
                                                              : "";
}

/// Extension modules, as NumPy's, name no library of Python: they find it among the global symbols,
/// where that of a part that was loaded at run time is not.
void share_symbols() {
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&Py_InitializeFromConfig), &info) != 0)
    dlopen(info.dli_fname, RTLD_LAZY | RTLD_GLOBAL | RTLD_NOLOAD);
}

void require(const PyStatus& status) {
  if (PyStatus_Exception(status))
    throw std::runtime_error(std::string("Python does not start: ") +
                             (status.err_msg != nullptr ? status.err_msg : "no reason given"));
}

struct Config : PyConfig {
  Config() { PyConfig_InitPythonConfig(this); }
  ~Config() { PyConfig_Clear(this); }
  Config(const Config&) = delete;
  Config& operator=(const Config&) = delete;
};

}  // namespace

void start_interpreter() {
  if (Py_IsInitialized() != 0) return;
  share_symbols();
  // Threads of numerical libraries would change the order of additions, and outlive runs.
  for (const char* name : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"})
    setenv(name, "1", 0);
  Config config;
  config.install_signal_handlers = 0;
  config.write_bytecode = 0;
  config.buffered_stdio = 0;  // what a method prints is of its run, also if it crashes
  config.use_hash_seed = 1;
  config.hash_seed = 0;
  const std::string path = interpreter_path();
  require(PyConfig_SetBytesString(&config, &config.program_name, path.c_str()));
  require(PyConfig_SetBytesString(&config, &config.executable, path.c_str()));
  if (const std::string home = bundled_home(); !home.empty())
    require(PyConfig_SetBytesString(&config, &config.home, home.c_str()));
  require(Py_InitializeFromConfig(&config));
  PyEval_SaveThread();
}

}  // namespace slalom
