# The readers and what they need, once more, compiled for libFuzzer with sanitizers; the rest of the project is not built.
set(ROOMS ${PROJECT_SOURCE_DIR}/modules)
set(FORMATS ${PROJECT_SOURCE_DIR}/adapters/map_formats/src)
file(GLOB FUZZED_ROOMS CONFIGURE_DEPENDS
  ${ROOMS}/core/src/*.cpp ${ROOMS}/scenario/src/*.cpp ${ROOMS}/trajectory/src/*.cpp)
add_library(slalom_fuzzed STATIC
  ${FUZZED_ROOMS}
  ${ROOMS}/io/src/compression.cpp
  ${ROOMS}/io/src/derived_speeds.cpp
  ${ROOMS}/io/src/file_access.cpp
  ${ROOMS}/io/src/findings_codec.cpp
  ${ROOMS}/io/src/scenario_codec.cpp
  ${ROOMS}/io/src/scenario_yaml.cpp
  ${ROOMS}/io/src/trajectory_file.cpp
  ${FORMATS}/grey_image.cpp
  ${FORMATS}/image_size.cpp
  ${FORMATS}/map_task.cpp
  ${FORMATS}/moving_ai.cpp
  ${FORMATS}/mrpt_maps.cpp
  ${FORMATS}/npy.cpp
  ${FORMATS}/point_map.cpp
  ${FORMATS}/ros_map.cpp
  ${FORMATS}/turned_grid.cpp)
foreach(room core scenario io map_formats)
  target_include_directories(slalom_fuzzed PUBLIC $<TARGET_PROPERTY:slalom_${room},INCLUDE_DIRECTORIES>)
  target_compile_definitions(slalom_fuzzed PUBLIC $<TARGET_PROPERTY:slalom_${room},COMPILE_DEFINITIONS>)
endforeach()
target_include_directories(slalom_fuzzed PUBLIC ${FORMATS} ${ROOMS}/io/src ${ROOMS}/scenario/src)
target_compile_options(slalom_fuzzed PUBLIC -fsanitize=fuzzer-no-link,address,undefined
                       -fno-sanitize-recover=undefined -fno-sanitize=vptr -fno-omit-frame-pointer)
target_link_libraries(slalom_fuzzed PUBLIC mrpt::config mrpt::math mrpt::maps mrpt::obs mrpt::img mrpt::poses
  mrpt::kinematics PkgConfig::xxhash PkgConfig::highway PkgConfig::zstd fmt::fmt yaml-cpp Boost::headers)

add_custom_target(fuzz)
foreach(target IN LISTS SLALOM_FUZZ_TARGETS)
  add_executable(fuzz_${target} ${target}_fuzz.cpp)
  target_link_libraries(fuzz_${target} PRIVATE slalom_fuzzed)
  target_link_options(fuzz_${target} PRIVATE -fsanitize=fuzzer,address,undefined)
  add_dependencies(fuzz fuzz_${target})
  add_test(NAME Fuzz.${target}
    COMMAND fuzz_${target} -max_total_time=8 -rss_limit_mb=2048 -timeout=10
            ${CMAKE_CURRENT_BINARY_DIR}/${target}_found ${CMAKE_CURRENT_SOURCE_DIR}/corpus/${target})
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${target}_found)
  set_tests_properties(Fuzz.${target} PROPERTIES TIMEOUT 120 LABELS "fuzz;slow")
endforeach()
