# Installs the programs' configurations, the headers of compiled methods and navigators, and a CMake package, so that a
# method is built out of tree by find_package(slalom) and slalom_add_method().
include(CMakePackageConfigHelpers)
set(SLALOM_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/slalom)

install(FILES ${PROJECT_SOURCE_DIR}/modules/methods/include/slalom/methods/slalom_method.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/slalom/methods)
install(FILES ${PROJECT_SOURCE_DIR}/adapters/mrpt_nav/include/slalom/mrpt_nav/navigator_plugin.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/slalom/mrpt_nav)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/slalom/configs)

install(TARGETS slalom_method_api EXPORT slalomTargets)
install(EXPORT slalomTargets NAMESPACE slalom:: DESTINATION ${SLALOM_PACKAGE_DIR})
install(FILES ${PROJECT_SOURCE_DIR}/cmake/SlalomMethod.cmake DESTINATION ${SLALOM_PACKAGE_DIR})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/slalomConfig.cmake.in
  ${PROJECT_BINARY_DIR}/slalomConfig.cmake INSTALL_DESTINATION ${SLALOM_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/slalomConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/slalomConfig.cmake ${PROJECT_BINARY_DIR}/slalomConfigVersion.cmake
        DESTINATION ${SLALOM_PACKAGE_DIR})
