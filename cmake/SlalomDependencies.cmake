# SPDX-License-Identifier: BSD-3-Clause
# Packages of other projects, all from the distribution, found by the targets that need them. Installed: find_package(slalom)
# with components includes it.
find_package(PkgConfig REQUIRED)
set(SLALOM_PKG_CONFIG_zstd libzstd)
set(SLALOM_PKG_CONFIG_xxhash libxxhash)
set(SLALOM_PKG_CONFIG_highway libhwy)
set(SLALOM_PKG_CONFIG_xlsxwriter xlsxwriter)

# slalom_find(TARGET [QUIET|REQUIRED]): the package of an imported target. Other names, as of the linker, have none. A macro,
# since packages set variables, too.
macro(slalom_find TARGET)
  if(TARGET ${TARGET})
  elseif(${TARGET} MATCHES "^mrpt::(.*)$")
    find_package(mrpt-${CMAKE_MATCH_1} ${ARGN})
  elseif(${TARGET} MATCHES "^PkgConfig::(.*)$")
    pkg_check_modules(${CMAKE_MATCH_1} ${ARGN} IMPORTED_TARGET ${SLALOM_PKG_CONFIG_${CMAKE_MATCH_1}})
  elseif(${TARGET} STREQUAL Boost::headers)
    find_package(Boost CONFIG ${ARGN})
  elseif(${TARGET} STREQUAL OMPL::OMPL)
    slalom_find_ompl(${ARGN})
  elseif(${TARGET} STREQUAL LCM::LCM)
    slalom_find_lcm(${ARGN})
  elseif(${TARGET} MATCHES "^pybind11::")
    # The distribution's interpreter, for which its packages (NumPy) are made, before others on the path.
    if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
      set(Python_EXECUTABLE /usr/bin/python3)
    endif()
    set(PYBIND11_FINDPYTHON ON)
    find_package(Python ${ARGN} COMPONENTS Interpreter Development)
    find_package(pybind11 ${ARGN})
  elseif(${TARGET} MATCHES "^opencv_(.*)$")
    find_package(OpenCV ${ARGN} COMPONENTS ${CMAKE_MATCH_1})
  elseif(${TARGET} MATCHES "^(yaml-cpp|SQLiteCpp)$")
    find_package(${CMAKE_MATCH_1} ${ARGN})
  elseif(${TARGET} MATCHES "^(.*)::")
    find_package(${CMAKE_MATCH_1} ${ARGN})
  endif()
  # Vectors of unknown size (ARM's SVE, RISC-V's RVV) cannot be members of a class and do not fit in buffers. A property of
  # the library: sources that call it cannot forget this.
  if(${TARGET} STREQUAL PkgConfig::highway AND TARGET PkgConfig::highway)
    set_target_properties(PkgConfig::highway PROPERTIES
      INTERFACE_COMPILE_DEFINITIONS "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128|HWY_RVV)")
  endif()
endmacro()

# OMPL's package defines variables only; a target keeps its include folders out of all other modules. Debian 13's lists
# folders of packages that it does not require (HDF5), which CMake refuses in a target where they are missing.
function(slalom_find_ompl)
  find_package(ompl ${ARGN})
  if(NOT ompl_FOUND)
    return()
  endif()
  add_library(OMPL::OMPL INTERFACE IMPORTED)
  foreach(folder IN LISTS OMPL_INCLUDE_DIRS)
    if(IS_DIRECTORY "${folder}")
      target_include_directories(OMPL::OMPL SYSTEM INTERFACE "${folder}")
    endif()
  endforeach()
  target_link_libraries(OMPL::OMPL INTERFACE ${OMPL_LIBRARIES})
endfunction()

# LCM's pkg-config file requires GLib's headers, which are not needed here.
function(slalom_find_lcm)
  list(REMOVE_ITEM ARGN QUIET)
  find_path(SLALOM_LCM_INCLUDE_DIR lcm/lcm-cpp.hpp ${ARGN})
  find_library(SLALOM_LCM_LIBRARY lcm ${ARGN})
  if(NOT SLALOM_LCM_INCLUDE_DIR OR NOT SLALOM_LCM_LIBRARY)
    return()
  endif()
  add_library(LCM::LCM INTERFACE IMPORTED)
  target_include_directories(LCM::LCM SYSTEM INTERFACE ${SLALOM_LCM_INCLUDE_DIR})
  target_link_libraries(LCM::LCM INTERFACE ${SLALOM_LCM_LIBRARY})
endfunction()
