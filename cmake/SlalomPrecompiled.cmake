# Headers of MRPT and the standard library that most sources include, compiled once for all modules and once for all
# tests; they take more than half of the compile time otherwise. Sources still include what they use: the build also
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

# For the modules that follow in modules/CMakeLists.txt: all of them depend on MRPT's maps.
function(slalom_precompile_for_modules)
  if(SLALOM_PRECOMPILE_HEADERS)
    add_library(slalom_precompiled STATIC ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(slalom_precompiled PRIVATE slalom_scenario)
    slalom_precompile(slalom_precompiled)
  endif()
endfunction()

# Compiling tests takes longer than the computations in them. With sanitizers most tests are not optimized at all, which
# compiles in a third of the time, except those that compute much themselves (COMPUTES of slalom_test).
set(SLALOM_TEST_OPTIMIZATION -O1)
set(SLALOM_COMPUTING_TEST_OPTIMIZATION -O1)
if(SLALOM_SANITIZE)
  set(SLALOM_TEST_OPTIMIZATION -O0)
endif()

# For tests: executables are compiled with other flags than code for shared libraries.
function(slalom_precompile_tests TARGET OPTIMIZATION)
  if(SLALOM_PRECOMPILE_HEADERS)
    add_executable(${TARGET} ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(${TARGET} PRIVATE slalom_scenario GTest::gtest GTest::gtest_main)
    target_compile_options(${TARGET} PRIVATE ${OPTIMIZATION})
    slalom_precompile(${TARGET} <gtest/gtest.h> <sstream>)
  endif()
endfunction()
