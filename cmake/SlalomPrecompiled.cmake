# SPDX-License-Identifier: BSD-3-Clause
# Headers of MRPT and the standard library that most sources include, compiled once for all modules, once for all
# programs and once for all tests; they take more than half of the compile time otherwise. Sources still include what they use: the build also
# works with -DSLALOM_PRECOMPILE_HEADERS=OFF.
set(SLALOM_PRECOMPILED_HEADERS
  <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <set> <string> <variant> <vector>
  <mrpt/maps/COccupancyGridMap2D.h> <mrpt/maps/CSimplePointsMap.h> <mrpt/math/TPoint2D.h> <mrpt/math/TPose2D.h>)
# Precompiled headers are valid only for the same macro definitions; most targets get this one from Boost.
if(SLALOM_PRECOMPILE_HEADERS)
  add_compile_definitions(BOOST_ALL_NO_LIB)
endif()
set(SLALOM_EMPTY_SOURCE ${CMAKE_CURRENT_LIST_DIR}/empty.cpp)

function(slalom_precompile TARGET)
  foreach(header ${SLALOM_PRECOMPILED_HEADERS} ${ARGN})
    target_precompile_headers(${TARGET} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${header}>")
  endforeach()
endfunction()

# Most code takes longer to compile than it ever runs: modules that compute much (COMPUTES of slalom_add_module) are
# optimized as the build type says, others by -O1; with sanitizers by -O1 and not at all. Tests: by -O1 or not at all.
if(SLALOM_SANITIZE)
  set(SLALOM_COMPUTING_OPTIMIZATION -O1)
  set(SLALOM_OPTIMIZATION -O0)
else()
  set(SLALOM_COMPUTING_OPTIMIZATION)
  set(SLALOM_OPTIMIZATION -O1)
endif()

# Compiles TARGET with this optimization, which may be empty, and the headers that slalom_precompile_for_*() compiled for it.
function(slalom_optimize TARGET PRECOMPILED OPTIMIZATION)
  target_compile_options(${TARGET} PRIVATE ${OPTIMIZATION})
  if(TARGET ${PRECOMPILED}${OPTIMIZATION})
    target_precompile_headers(${TARGET} REUSE_FROM ${PRECOMPILED}${OPTIMIZATION})
  endif()
endfunction()

# For the modules that are added after it: all of them depend on MRPT's maps.
function(slalom_precompile_for_modules OPTIMIZATION)
  if(SLALOM_PRECOMPILE_HEADERS)
    set(target slalom_precompiled${OPTIMIZATION})
    add_library(${target} STATIC ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(${target} PRIVATE slalom_scenario)
    target_compile_options(${target} PRIVATE ${OPTIMIZATION})
    slalom_precompile(${target})
  endif()
endfunction()

# For tests: executables are compiled with other flags than code for shared libraries.
function(slalom_precompile_for_tests OPTIMIZATION)
  if(SLALOM_PRECOMPILE_HEADERS)
    set(target slalom_precompiled_test${OPTIMIZATION})
    add_executable(${target} ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(${target} PRIVATE slalom_scenario GTest::gtest GTest::gtest_main)
    target_compile_options(${target} PRIVATE ${OPTIMIZATION})
    slalom_precompile(${target} <gtest/gtest.h> <sstream>)
  endif()
endfunction()

# For the programs: all of them parse command lines, most write JSON.
function(slalom_precompile_for_apps OPTIMIZATION)
  if(SLALOM_PRECOMPILE_HEADERS)
    set(target slalom_precompiled_app${OPTIMIZATION})
    add_executable(${target} ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(${target} PRIVATE slalom_scenario CLI11::CLI11 nlohmann_json::nlohmann_json)
    target_compile_options(${target} PRIVATE ${OPTIMIZATION})
    slalom_precompile(${target} <CLI/CLI.hpp> <nlohmann/json.hpp> <iostream>)
  endif()
endfunction()
