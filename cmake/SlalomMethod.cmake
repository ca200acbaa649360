# SPDX-License-Identifier: BSD-3-Clause
# slalom_add_method(NAME source...): an avoidance method as a shared library with the plain C prototype of
# <slalom/methods/slalom_method.h>. All symbols except the exported function are hidden.
function(slalom_add_method NAME)
  add_library(${NAME} MODULE ${ARGN})
  target_link_libraries(${NAME} PRIVATE slalom::method_api)
  set_target_properties(${NAME} PROPERTIES
    C_VISIBILITY_PRESET hidden
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
endfunction()
