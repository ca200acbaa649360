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

# With sanitizers, code is not optimized, which compiles in a third of the time, except modules and tests that compute
# much (COMPUTES of slalom_add_module and slalom_test). In other builds modules are as the build type says; compiling
# tests takes longer than the computations in them.
set(SLALOM_TEST_OPTIMIZATION -O1)
set(SLALOM_COMPUTING_OPTIMIZATION)
if(SLALOM_SANITIZE)
  set(SLALOM_TEST_OPTIMIZATION -O0)
  set(SLALOM_COMPUTING_OPTIMIZATION -O1)
endif()

# Precompiled headers are valid only for the same optimization: TARGET uses those of PRECOMPILED or PRECOMPILED_computing.
function(slalom_optimize TARGET PRECOMPILED COMPUTES)
  if(COMPUTES AND SLALOM_SANITIZE)
    target_compile_options(${TARGET} PRIVATE ${SLALOM_COMPUTING_OPTIMIZATION})
    string(APPEND PRECOMPILED _computing)
  endif()
  if(TARGET ${PRECOMPILED})
    target_precompile_headers(${TARGET} REUSE_FROM ${PRECOMPILED})
  endif()
endfunction()

# For the modules that follow in modules/CMakeLists.txt: all of them depend on MRPT's maps.
function(slalom_precompile_for_modules TARGET)
  if(SLALOM_PRECOMPILE_HEADERS)
    add_library(${TARGET} STATIC ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(${TARGET} PRIVATE slalom_scenario)
    target_compile_options(${TARGET} PRIVATE ${ARGN})
    slalom_precompile(${TARGET})
  endif()
endfunction()

# For tests: executables are compiled with other flags than code for shared libraries.
function(slalom_precompile_tests TARGET OPTIMIZATION)
  if(SLALOM_PRECOMPILE_HEADERS)
    add_executable(${TARGET} ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(${TARGET} PRIVATE slalom_scenario GTest::gtest GTest::gtest_main)
    target_compile_options(${TARGET} PRIVATE ${OPTIMIZATION})
    slalom_precompile(${TARGET} <gtest/gtest.h> <sstream>)
  endif()
endfunction()

# For the programs: all of them parse command lines, most write JSON.
function(slalom_precompile_for_apps TARGET)
  if(SLALOM_PRECOMPILE_HEADERS)
    add_executable(${TARGET} ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(${TARGET} PRIVATE slalom_scenario CLI11::CLI11 nlohmann_json::nlohmann_json)
    slalom_precompile(${TARGET} <CLI/CLI.hpp> <nlohmann/json.hpp> <iostream>)
  endif()
endfunction()
