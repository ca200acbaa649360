# SPDX-License-Identifier: BSD-3-Clause
# What Slalom is built from: the packages that all of it needs, and the optional parts.
foreach(target mrpt::config mrpt::math mrpt::maps mrpt::obs mrpt::img mrpt::io mrpt::kinematics mrpt::nav mrpt::poses
        Boost::headers Threads::Threads SQLiteCpp nlohmann_json::nlohmann_json yaml-cpp ZLIB::ZLIB BZip2::BZip2 PNG::PNG
        PkgConfig::lz4 PkgConfig::minizip PkgConfig::xxhash PkgConfig::zstd PkgConfig::highway fmt::fmt CLI11::CLI11 tinyxml2::tinyxml2)
  slalom_find(${target} REQUIRED)
endforeach()

# slalom_part(NAME TEXT TARGET...): the option SLALOM_WITH_NAME, on where the packages of all targets are found, and its C++
# macro of the same name.
macro(slalom_part NAME TEXT)
  set(found ON)
  foreach(target ${ARGN})
    if(NOT DEFINED SLALOM_WITH_${NAME})
      slalom_find(${target} QUIET)
      if(NOT TARGET ${target})
        set(found OFF)
      endif()
    endif()
  endforeach()
  option(SLALOM_WITH_${NAME} "${TEXT}" ${found})
  if(SLALOM_WITH_${NAME})
    foreach(target ${ARGN})
      slalom_find(${target} REQUIRED)
    endforeach()
    list(APPEND SLALOM_PARTS SLALOM_WITH_${NAME})
  else()
    list(APPEND SLALOM_ABSENT_PARTS SLALOM_WITH_${NAME})
  endif()
endmacro()

slalom_part(OMPL "Reference paths by OMPL's planners: robots that are not discs or do not turn in place" OMPL::OMPL)
slalom_part(LCM "Methods in other processes" LCM::LCM program::lcm-gen)
slalom_part(ROS2 "Methods that are nodes of ROS 2, by Cyclone DDS" CycloneDDS::ddsc program::idlc)
slalom_part(PYTHON "Methods in Python, and the Python package" pybind11::embed)
slalom_part(ONNX "Networks as methods, by OpenCV" opencv_core opencv_dnn)
slalom_part(XLSX "Tables as spreadsheets" PkgConfig::xlsxwriter)
slalom_part(GUI "Slalom Studio and the window of slalom-replay" mrpt::gui OpenGL::GL)
foreach(part ${SLALOM_ABSENT_PARTS})
  message(STATUS "Not built: ${part}")
endforeach()
