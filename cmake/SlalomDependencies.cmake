# SPDX-License-Identifier: BSD-3-Clause
# Third-party dependencies of the libraries, all from the distribution's packages. Installed: find_package(slalom) with
# components includes it.
find_package(mrpt-config REQUIRED)
find_package(mrpt-math REQUIRED)
find_package(mrpt-maps REQUIRED)
find_package(mrpt-obs REQUIRED)
find_package(mrpt-img REQUIRED)
find_package(mrpt-kinematics REQUIRED)
find_package(mrpt-nav REQUIRED)
find_package(Boost REQUIRED CONFIG)
find_package(Threads REQUIRED)
find_package(SQLiteCpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(ompl REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PNG REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(zstd REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(xlsxwriter REQUIRED IMPORTED_TARGET xlsxwriter)
pkg_check_modules(highway REQUIRED IMPORTED_TARGET libhwy)
find_package(fmt REQUIRED)

# Vectors of unknown size (ARM's SVE, RISC-V's RVV) cannot be members of a class and do not fit in buffers. A property of
# the library: sources that call it cannot forget this.
set_target_properties(PkgConfig::highway PROPERTIES
  INTERFACE_COMPILE_DEFINITIONS "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128|HWY_RVV)")

# OMPL's package defines variables only; a target keeps its include folders out of all other modules. Debian 13's lists
# folders of packages that it does not require (HDF5), which CMake refuses in a target where they are missing.
if(NOT TARGET OMPL::OMPL)
  add_library(OMPL::OMPL INTERFACE IMPORTED)
  foreach(folder IN LISTS OMPL_INCLUDE_DIRS)
    if(IS_DIRECTORY "${folder}")
      target_include_directories(OMPL::OMPL SYSTEM INTERFACE "${folder}")
    endif()
  endforeach()
  target_link_libraries(OMPL::OMPL INTERFACE ${OMPL_LIBRARIES})
endif()

# LCM's pkg-config file requires GLib's headers, which are not needed here.
find_path(SLALOM_LCM_INCLUDE_DIR lcm/lcm-cpp.hpp REQUIRED)
find_library(SLALOM_LCM_LIBRARY lcm REQUIRED)
if(NOT TARGET LCM::LCM)
  add_library(LCM::LCM INTERFACE IMPORTED)
  target_include_directories(LCM::LCM SYSTEM INTERFACE ${SLALOM_LCM_INCLUDE_DIR})
  target_link_libraries(LCM::LCM INTERFACE ${SLALOM_LCM_LIBRARY})
endif()

# The distribution's interpreter, for which its packages (NumPy) are made, before others on the path.
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
set(PYBIND11_FINDPYTHON ON)
find_package(Python REQUIRED COMPONENTS Interpreter Development)
find_package(pybind11 REQUIRED)
