# SPDX-License-Identifier: BSD-3-Clause
# Debian packages, "cpack -G DEB" or scripts/package.sh: one for each component of the installation.
set(SLALOM_COMPONENTS programs development python documentation)
set(package_of_programs slalom)
set(package_of_development libslalom-dev)
set(package_of_python python3-slalom)
set(package_of_documentation slalom-doc)

# The contents of packages, without the tests.
get_property(apps GLOBAL PROPERTY SLALOM_APPS)
add_custom_target(packaged DEPENDS slalom_reactive_methods slalom_parts ${apps})
if(NOT SLALOM_SANITIZE)
  list(TRANSFORM apps APPEND -man)
  add_dependencies(packaged slalom_library_c ${apps})
endif()
foreach(module ${modules})
  add_dependencies(packaged slalom_${module})
endforeach()

install(DIRECTORY ${PROJECT_BINARY_DIR}/site/ DESTINATION ${CMAKE_INSTALL_DOCDIR}-doc/html COMPONENT documentation
        OPTIONAL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}-doc/guide COMPONENT documentation
        PATTERN Doxyfile EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}-doc/examples
        COMPONENT documentation)

# Files that Debian requires of every package: the license, and the changelog of the package.
set(legal ${PROJECT_BINARY_DIR}/packages)
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
string(REGEX REPLACE "\n\n+" "\n.\n" license "${license}")
string(REGEX REPLACE "\n([^\n])" "\n \\1" license " ${license}")
# The project states no address. Whoever distributes packages gives theirs.
set(SLALOM_MAINTAINER "The Slalom authors <slalom@packages.invalid>" CACHE STRING "Maintainer of the packages: NAME <ADDRESS>")
configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright.in ${legal}/copyright @ONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in ${legal}/changelog.Debian @ONLY)
execute_process(COMMAND gzip -9nkf ${legal}/changelog.Debian)
foreach(component ${SLALOM_COMPONENTS})
  install(FILES ${legal}/copyright ${legal}/changelog.Debian.gz COMPONENT ${component}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package_of_${component}} EXCLUDE_FROM_ALL)
  string(TOUPPER ${component} COMPONENT)
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME ${package_of_${component}})
endforeach()

# The libraries need the development packages with which they are built.
file(STRINGS ${PROJECT_SOURCE_DIR}/scripts/packages.txt needed
     REGEX "^(cmake|pkg-config|lib.*-dev|nlohmann.*|python3-dev|pybind11-dev|zlib1g-dev)$")
list(FILTER needed EXCLUDE REGEX "benchmark|gtest|rapidcheck|cli11|libgl-dev")
list(JOIN needed ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", slalom (= ${PROJECT_VERSION}-1)")  # which has libslalom.so
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.8), python3-numpy, slalom (= ${PROJECT_VERSION}-1)")
# Python writes compiled modules beside those of the package.
file(CONFIGURE OUTPUT ${legal}/prerm
     CONTENT "#!/bin/sh\nset -e\nrm -rf /usr/lib/python3/dist-packages/slalom/__pycache__\n")
file(CHMOD ${legal}/prerm PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${legal}/prerm)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "python3-numpy")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "libslalom-dev, python3-slalom, slalom-doc")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_DEPENDS "libjs-mathjax")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # scripts/package.sh builds the target packaged
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL ${SLALOM_COMPONENTS})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "${SLALOM_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "evaluation of obstacle avoidance methods for mobile robots")
string(CONCAT about
       "Slalom simulates a mobile robot under each of several obstacle avoidance\n"
       "methods in hundreds of scenarios, compares every run with the best possible\n"
       "path, and relates properties of the scenarios to the performance.")
set(holds_programs "the programs, shipped methods and example campaigns")
set(holds_development "the static libraries, headers and the package of CMake")
set(holds_python "the Python package slalom")
set(holds_documentation "the API reference, the guide and examples")
foreach(component ${SLALOM_COMPONENTS})
  string(TOUPPER ${component} COMPONENT)
  set(CPACK_COMPONENT_${COMPONENT}_DESCRIPTION "${about}\nThis package contains ${holds_${component}}.")
endforeach()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Not for documentation, whose thousands of files would be examined one by one.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
include(CPack)
