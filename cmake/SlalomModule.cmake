# SPDX-License-Identifier: BSD-3-Clause
# slalom_add_module(NAME [COMPUTES] [IN_SMALL_UNITS] SOURCES a.cpp ... DEPENDS module ... LIBRARIES target ...)
#
# A module of modules/ (or adapters/): one static library target slalom_NAME with one include root of its own. It includes
# headers only of core and of the modules in DEPENDS (scripts/check_includes.py). COMPUTES: see SlalomPrecompiled.cmake.
# IN_SMALL_UNITS: GCC inlines less in a larger unit, where exact paths take 1.24 times as long.
function(slalom_add_module NAME)
  cmake_parse_arguments(MODULE "COMPUTES;IN_SMALL_UNITS" "" "SOURCES;DEPENDS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  add_library(slalom_${NAME} STATIC ${MODULE_SOURCES})
  add_library(slalom::${NAME} ALIAS slalom_${NAME})
  target_include_directories(slalom_${NAME} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(slalom_${NAME} PUBLIC cxx_std_17)
  set_property(GLOBAL APPEND PROPERTY SLALOM_MODULES ${NAME})
  list(TRANSFORM MODULE_DEPENDS PREPEND slalom_)
  target_link_libraries(slalom_${NAME} PUBLIC ${MODULE_DEPENDS} ${MODULE_LIBRARIES} PRIVATE ${MODULE_PRIVATE_LIBRARIES})
  if(MODULE_COMPUTES)
    slalom_optimize(slalom_${NAME} slalom_precompiled "${SLALOM_COMPUTING_OPTIMIZATION}")
  else()
    slalom_optimize(slalom_${NAME} slalom_precompiled ${SLALOM_OPTIMIZATION})
  endif()
  if(MODULE_IN_SMALL_UNITS AND NOT SLALOM_SANITIZE)
    set_target_properties(slalom_${NAME} PROPERTIES UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

# slalom_add_part(NAME SOURCES a.cpp ... MODULES module ...): a part of Slalom with large dependencies, as the library
# lib/slalom/runtime/libslalom_NAME.so, which programs load when they first need it (slalom/library/part.h). It is none of
# their dependencies; the target all builds it.
function(slalom_add_part NAME)
  cmake_parse_arguments(PART "" "" "SOURCES;MODULES" ${ARGN})
  add_library(slalom_${NAME}_part MODULE ${PART_SOURCES} ${PROJECT_SOURCE_DIR}/adapters/methods/library/src/part_build_id.cpp)
  list(TRANSFORM PART_MODULES PREPEND slalom_)
  target_link_libraries(slalom_${NAME}_part PRIVATE ${PART_MODULES} slalom_build_id)
  set_target_properties(slalom_${NAME}_part PROPERTIES
    OUTPUT_NAME slalom_${NAME} CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/slalom/runtime)
  add_dependencies(slalom_parts slalom_${NAME}_part)
  install(TARGETS slalom_${NAME}_part LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/slalom/runtime)
endfunction()

# slalom_app(NAME SOURCES ... DEPENDS module ... LIBRARIES target ...): a program in build/.../bin, its manual page in
# build/.../man, and its completion.
function(slalom_app NAME)
  cmake_parse_arguments(APP "" "" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  add_executable(${NAME} ${APP_SOURCES})
  list(TRANSFORM APP_DEPENDS PREPEND slalom_)
  target_link_libraries(${NAME} PRIVATE ${APP_DEPENDS} ${APP_LIBRARIES})
  list(LENGTH APP_SOURCES count)
  if(count GREATER 2)
    slalom_optimize(${NAME} slalom_precompiled_app ${SLALOM_OPTIMIZATION})
  else()  # one unit: slalom-evaluate is built first, and should not wait for headers of all programs
    target_compile_options(${NAME} PRIVATE ${SLALOM_OPTIMIZATION})
  endif()
  if(TARGET slalom_image_codecs)
    target_link_libraries(${NAME} PRIVATE slalom_image_codecs)
    set_target_properties(${NAME} PROPERTIES INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR}/slalom/runtime)
  endif()
  install(TARGETS ${NAME} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  set_property(GLOBAL APPEND PROPERTY SLALOM_APPS ${NAME})
  configure_file(${PROJECT_SOURCE_DIR}/apps/completion/slalom.bash.in ${CMAKE_BINARY_DIR}/completion/${NAME} @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/completion/${NAME} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  if(SLALOM_SANITIZE)
    return()
  endif()
  set(page ${CMAKE_BINARY_DIR}/man/${NAME}.1)
  add_custom_command(OUTPUT ${page}.gz
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/man
    COMMAND sh -c "'$<TARGET_FILE:${NAME}>' --man-page > '${page}' && gzip -9nf '${page}'"
    DEPENDS ${NAME} VERBATIM)
  add_custom_target(${NAME}-man ALL DEPENDS ${page}.gz)
  # Optional, as a build of single programs has no pages.
  install(FILES ${page}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
endfunction()

# slalom_test(NAME [COMPUTES] SOURCES ... DEPENDS module ... LIBRARIES target ... LONG test ...): a GoogleTest program, one per
# module, and one test of ctest: a program with MRPT's libraries takes a while to start, so that one process for each test
# would take longer than the tests. One test alone: build/release/bin/NAME --gtest_filter=SUITE.TEST. LONG are tests (patterns
# of GoogleTest) with thousands of runs or samples of what others run less often: not under sanitizers.
function(slalom_test NAME)
  cmake_parse_arguments(TEST "COMPUTES" "" "SOURCES;DEPENDS;LIBRARIES;LONG" ${ARGN})
  add_executable(${NAME} ${TEST_SOURCES})
  list(TRANSFORM TEST_DEPENDS PREPEND slalom_)
  target_link_libraries(${NAME} PRIVATE
    ${TEST_DEPENDS} ${TEST_LIBRARIES} slalom_test_places GTest::gtest GTest::gtest_main Threads::Threads)
  if(TARGET slalom_image_codecs)
    target_link_libraries(${NAME} PRIVATE slalom_image_codecs)
  endif()
  target_include_directories(${NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  set(optimization -O0)
  if(TEST_COMPUTES)
    set(optimization -O1)
  endif()
  slalom_optimize(${NAME} slalom_precompiled_test ${optimization})
  add_dependencies(${NAME} slalom_parts)  # which the programs that it starts may load
  add_test(NAME ${NAME} COMMAND ${NAME})
  set_tests_properties(${NAME} PROPERTIES TIMEOUT ${SLALOM_TEST_TIMEOUT})
  if(SLALOM_SANITIZE AND TEST_LONG)
    list(JOIN TEST_LONG : long)
    set_tests_properties(${NAME} PROPERTIES ENVIRONMENT GTEST_FILTER=-${long})
  endif()
endfunction()
