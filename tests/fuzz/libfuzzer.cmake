# SPDX-License-Identifier: BSD-3-Clause
# The readers and their dependencies, compiled for libFuzzer with sanitizers; the rest of the project is not built.
set(MODULES ${PROJECT_SOURCE_DIR}/modules)
set(BAGS ${PROJECT_SOURCE_DIR}/adapters/formats/bags/src)
set(FORMATS ${PROJECT_SOURCE_DIR}/adapters/formats/map_formats/src)
set(PARAMETERS ${PROJECT_SOURCE_DIR}/adapters/formats/ros_parameters/src)
set(TABLES ${PROJECT_SOURCE_DIR}/adapters/formats/tables/src)
foreach(module analysis core scenario trajectory results)
  get_target_property(sources slalom_${module} SOURCES)
  get_target_property(folder slalom_${module} SOURCE_DIR)
  list(TRANSFORM sources PREPEND ${folder}/)
  list(APPEND FUZZED_SOURCES ${sources})
endforeach()
add_library(slalom_fuzzed STATIC
  ${FUZZED_SOURCES}
  ${MODULES}/study/campaign/src/wire.cpp
  ${MODULES}/inquiry/falsification/src/search_state.cpp
  ${MODULES}/inquiry/falsification/src/trial_codec.cpp
  ${MODULES}/data/io/src/checked_row.cpp
  ${MODULES}/data/io/src/compression.cpp
  ${MODULES}/data/io/src/database.cpp
  ${MODULES}/data/io/src/sibling_temp_file.cpp
  ${MODULES}/data/io/src/file_access.cpp
  ${MODULES}/data/io/src/result/campaign_identity.cpp
  ${MODULES}/data/io/src/result/combined_results.cpp
  ${MODULES}/data/io/src/result/derived_speeds.cpp
  ${MODULES}/data/io/src/result/dump.cpp
  ${MODULES}/data/io/src/result/echoed_messages.cpp
  ${MODULES}/data/io/src/result/file_rows.cpp
  ${MODULES}/data/io/src/result/log_columns.cpp
  ${MODULES}/data/io/src/result/merge_results.cpp
  ${MODULES}/data/io/src/result/packed_scenario.cpp
  ${MODULES}/data/io/src/result/packed_trajectory.cpp
  ${MODULES}/data/io/src/result/read_results.cpp
  ${MODULES}/data/io/src/result/result_reader.cpp
  ${MODULES}/data/io/src/result/result_schema.cpp
  ${MODULES}/data/io/src/result/result_writer.cpp
  ${MODULES}/data/io/src/scenario/scenario_codec.cpp
  ${MODULES}/data/io/src/scenario/hunav_agents.cpp
  ${MODULES}/data/io/src/scenario/movers_file.cpp
  ${MODULES}/data/io/src/scenario/movers_yaml.cpp
  ${MODULES}/data/io/src/scenario/scenario_yaml.cpp
  ${MODULES}/data/io/src/scenario/yaml_reader.cpp
  ${MODULES}/data/io/src/result/trajectory_file.cpp
  ${MODULES}/data/io/src/text_lines.cpp
  ${MODULES}/data/io/src/transaction.cpp
  ${MODULES}/world/references/src/reference_codec.cpp
  ${BAGS}/bag_info.cpp
  ${BAGS}/bag_info_text.cpp
  ${BAGS}/bag_trajectory.cpp
  ${BAGS}/chunk_data.cpp
  ${BAGS}/frame_tree.cpp
  ${BAGS}/mcap_bag.cpp
  ${BAGS}/read_bag.cpp
  ${BAGS}/ros1_bag.cpp
  ${BAGS}/ros_messages.cpp
  ${BAGS}/sqlite_bag.cpp
  ${BAGS}/topic_choice.cpp
  ${FORMATS}/arena_scenario.cpp
  ${FORMATS}/gazebo_world.cpp
  ${FORMATS}/gray_image.cpp
  ${FORMATS}/image_size.cpp
  ${FORMATS}/map_pairs.cpp
  ${FORMATS}/map_task.cpp
  ${FORMATS}/moving_ai.cpp
  ${FORMATS}/image_map.cpp
  ${FORMATS}/ir_sim_world.cpp
  ${FORMATS}/map_import.cpp
  ${FORMATS}/mrpt_maps.cpp
  ${FORMATS}/mvsim_world.cpp
  ${FORMATS}/npy.cpp
  ${FORMATS}/png_image.cpp
  ${FORMATS}/point_map.cpp
  ${FORMATS}/ros_map.cpp
  ${FORMATS}/rotated_grid.cpp
  ${FORMATS}/stage_world.cpp
  ${FORMATS}/world_import.cpp
  ${FORMATS}/world_parts.cpp
  ${PROJECT_SOURCE_DIR}/adapters/formats/xml/src/xml_file.cpp
  ${MODULES}/world/robot/src/footprint.cpp
  ${MODULES}/world/robot/src/robot_model.cpp
  ${MODULES}/run/simulation/src/simulation_options.cpp
  ${PARAMETERS}/conversions.cpp
  ${PARAMETERS}/parameter_files.cpp
  ${PARAMETERS}/parameter_table.cpp
  ${PARAMETERS}/resolve.cpp
  ${TABLES}/foreign_table.cpp
  ${TABLES}/json_table.cpp
  ${TABLES}/workbook_table.cpp)
foreach(module analysis core scenario io campaign falsification map_formats ros_parameters bags xml)
  target_include_directories(slalom_fuzzed PUBLIC $<TARGET_PROPERTY:slalom_${module},INCLUDE_DIRECTORIES>)
  target_compile_definitions(slalom_fuzzed PUBLIC $<TARGET_PROPERTY:slalom_${module},COMPILE_DEFINITIONS>)
endforeach()
target_include_directories(slalom_fuzzed PUBLIC ${FORMATS} ${MODULES}/study/campaign/src ${MODULES}/data/io/src
                                                ${TABLES} ${MODULES}/world/scenario/src)
target_compile_options(slalom_fuzzed PUBLIC -fsanitize=fuzzer-no-link,address,undefined
                       -fno-sanitize-recover=undefined -fno-sanitize=vptr -fno-omit-frame-pointer)
target_link_libraries(slalom_fuzzed PUBLIC mrpt::config mrpt::math mrpt::maps mrpt::obs mrpt::img mrpt::poses
  mrpt::kinematics PkgConfig::xxhash PkgConfig::highway PkgConfig::zstd PkgConfig::lz4 PkgConfig::minizip BZip2::BZip2 ZLIB::ZLIB fmt::fmt yaml-cpp PNG::PNG tinyxml2::tinyxml2 Boost::headers
  SQLiteCpp SQLite::SQLite3 nlohmann_json::nlohmann_json)

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
  set_tests_properties(Fuzz.${target} PROPERTIES TIMEOUT ${SLALOM_TEST_TIMEOUT} LABELS "fuzz;slow")
endforeach()
