# SPDX-License-Identifier: BSD-3-Clause
# Compiler settings of all targets.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(SLALOM_CCACHE ccache)
if(SLALOM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # The first is required by ccache for precompiled headers; by the others, builds in several folders share objects, those
  # with debug information too (not with CCACHE_DEPEND: units name their sources by absolute paths; nor with a precompiled
  # header of clang, whose bytes depend on the folder).
  set(launcher ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=true ${SLALOM_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
endif()
if(SLALOM_PRECOMPILE_HEADERS AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
endif()

# Linked in a test: GCC before 12.1 refuses the option, and cross compilers do not find the host's mold.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=mold SLALOM_LINKS_WITH_MOLD)
if(SLALOM_LINKS_WITH_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

# Results must not depend on whether the compiler fuses a multiply with an add.
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  add_compile_options(-Wno-sign-conversion)  # Clang's -Wconversion includes it, GCC's does not
endif()
if(SLALOM_WARNINGS_AS_ERRORS)
  add_compile_options(-Werror)
endif()
if(SLALOM_SANITIZE)
  add_compile_definitions(SLALOM_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
