# Headers of MRPT and the standard library that most sources include, compiled once for all rooms and once for all
# tests: more than half of the compiler's time otherwise. Sources include what they use all the same: the build works
# with -DSLALOM_PRECOMPILE_HEADERS=OFF.
set(SLALOM_PRECOMPILED_HEADERS
  <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <set> <string> <variant> <vector>
  <mrpt/maps/COccupancyGridMap2D.h> <mrpt/maps/CSimplePointsMap.h> <mrpt/math/TPoint2D.h> <mrpt/math/TPose2D.h>)
# Precompiled headers are good only where the same macros are defined: this one comes with Boost in most targets.
if(SLALOM_PRECOMPILE_HEADERS)
  add_compile_definitions(BOOST_ALL_NO_LIB)
endif()
set(SLALOM_EMPTY_SOURCE ${CMAKE_CURRENT_LIST_DIR}/empty.cpp)

function(slalom_precompile TARGET)
  foreach(header ${SLALOM_PRECOMPILED_HEADERS} ${ARGN})
    target_precompile_headers(${TARGET} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${header}>")
  endforeach()
endfunction()

# For rooms above this one in the list of rooms: they all know MRPT's maps.
function(slalom_precompile_for_rooms)
  if(SLALOM_PRECOMPILE_HEADERS)
    add_library(slalom_precompiled STATIC ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(slalom_precompiled PRIVATE slalom_scenario)
    slalom_precompile(slalom_precompiled)
  endif()
endfunction()

# For tests, whose code is not for shared libraries and is therefore compiled otherwise.
function(slalom_precompile_for_tests)
  if(SLALOM_PRECOMPILE_HEADERS)
    add_executable(slalom_precompiled_test ${SLALOM_EMPTY_SOURCE})
    target_link_libraries(slalom_precompiled_test PRIVATE slalom_scenario GTest::gtest GTest::gtest_main)
    slalom_precompile(slalom_precompiled_test <gtest/gtest.h> <sstream>)
  endif()
endfunction()
