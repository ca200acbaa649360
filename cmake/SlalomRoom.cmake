# slalom_room(NAME SOURCES a.cpp ... DEPENDS room ... LIBRARIES target ...)
#
# One room of modules/ (or adapters/): one static library target slalom_NAME with one include root of its
# own, so that a header of a room that is not in DEPENDS cannot be included by accident.
function(slalom_room NAME)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  add_library(slalom_${NAME} STATIC ${ROOM_SOURCES})
  add_library(slalom::${NAME} ALIAS slalom_${NAME})
  target_include_directories(slalom_${NAME} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  list(TRANSFORM ROOM_DEPENDS PREPEND slalom_)
  target_link_libraries(slalom_${NAME} PUBLIC ${ROOM_DEPENDS} ${ROOM_LIBRARIES} PRIVATE ${ROOM_PRIVATE_LIBRARIES})
  if(TARGET slalom_precompiled)
    target_precompile_headers(slalom_${NAME} REUSE_FROM slalom_precompiled)
  endif()
endfunction()

# slalom_app(NAME SOURCES ... DEPENDS room ... LIBRARIES target ...): a program in build/.../bin.
function(slalom_app NAME)
  cmake_parse_arguments(APP "" "" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  add_executable(${NAME} ${APP_SOURCES})
  list(TRANSFORM APP_DEPENDS PREPEND slalom_)
  target_link_libraries(${NAME} PRIVATE ${APP_DEPENDS} ${APP_LIBRARIES})
  install(TARGETS ${NAME} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()

# slalom_test(NAME SOURCES ... DEPENDS room ... LIBRARIES target ...): a GoogleTest program, one per room.
function(slalom_test NAME)
  cmake_parse_arguments(TEST "" "" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  add_executable(${NAME} ${TEST_SOURCES})
  list(TRANSFORM TEST_DEPENDS PREPEND slalom_)
  target_link_libraries(${NAME} PRIVATE ${TEST_DEPENDS} ${TEST_LIBRARIES} GTest::gtest GTest::gtest_main Threads::Threads)
  target_include_directories(${NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  if(TARGET slalom_precompiled_test)
    target_precompile_headers(${NAME} REUSE_FROM slalom_precompiled_test)
  endif()
  gtest_discover_tests(${NAME} PROPERTIES TIMEOUT 300 DISCOVERY_TIMEOUT 120)
endfunction()
