# SPDX-License-Identifier: BSD-3-Clause
# Installs the example configurations, the modules and adapters as static libraries with their headers, and a CMake
# package: find_package(slalom) for methods built out of tree, with components for programs that use the libraries.
include(CMakePackageConfigHelpers)
set(SLALOM_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/slalom)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/slalom/configs)
# Programs find the demo and the tables of difficulty from their own folder, also before they are installed.
foreach(config demo.ini testbeds/slalom-small.difficulty.csv testbeds/slalom-standard.difficulty.csv)
  configure_file(${PROJECT_SOURCE_DIR}/configs/${config} ${PROJECT_BINARY_DIR}/share/slalom/configs/${config} COPYONLY)
endforeach()
# The maps of the demo, as systems without MRPT lack them.
foreach(map malaga-cs-fac-building localization_demo)
  install(FILES /usr/share/mrpt/datasets/${map}.simplemap.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/slalom/datasets)
endforeach()

# The window is a program, not a library.
get_property(modules GLOBAL PROPERTY SLALOM_MODULES)
list(REMOVE_ITEM modules gui)
foreach(module ${modules})
  get_target_property(folder slalom_${module} SOURCE_DIR)
  install(DIRECTORY ${folder}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  set_target_properties(slalom_${module} PROPERTIES EXPORT_NAME ${module})
  install(TARGETS slalom_${module} EXPORT slalomLibraries ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          COMPONENT development)
endforeach()
if(SLALOM_WITH_LCM)
  install(TARGETS slalom_lcm_types EXPORT slalomLibraries)
endif()
install(EXPORT slalomLibraries NAMESPACE slalom:: DESTINATION ${SLALOM_PACKAGE_DIR} COMPONENT development)
install(TARGETS slalom_method_api EXPORT slalomTargets)
install(EXPORT slalomTargets NAMESPACE slalom:: DESTINATION ${SLALOM_PACKAGE_DIR} COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/SlalomMethod.cmake ${PROJECT_SOURCE_DIR}/cmake/SlalomDependencies.cmake
        DESTINATION ${SLALOM_PACKAGE_DIR} COMPONENT development)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/slalomConfig.cmake.in
  ${PROJECT_BINARY_DIR}/slalomConfig.cmake INSTALL_DESTINATION ${SLALOM_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/slalomConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/slalomConfig.cmake ${PROJECT_BINARY_DIR}/slalomConfigVersion.cmake
        DESTINATION ${SLALOM_PACKAGE_DIR} COMPONENT development)

# Completion for zsh, in the folder that Debian's zsh searches below /usr.
get_property(SLALOM_APPS GLOBAL PROPERTY SLALOM_APPS)
list(JOIN SLALOM_APPS " " SLALOM_PROGRAM_NAMES)
configure_file(${PROJECT_SOURCE_DIR}/apps/completion/_slalom.in ${PROJECT_BINARY_DIR}/completion/_slalom @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/completion/_slalom DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
