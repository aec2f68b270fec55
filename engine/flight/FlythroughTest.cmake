# For map authors: make a flythrough a test of CTest, in this project or in your own.
#
#   find_package(Enfilade REQUIRED)        # or FetchContent, or add_subdirectory
#   enfilade_add_flythrough_test(NAME my_walk SCRIPT my_walk.toml)
#
# NAME      of the test
# SCRIPT    the flythrough, relative to the calling CMakeLists.txt; its recorded hashes are in my_walk.hashes beside it,
#           small pictures of some frames in my_walk.sheet.png (record both with: enfilade fly my_walk.toml --record)
# AGAINST   optional: compare with another renderer instead of the record, e.g. reference
# OPTIONS   optional: more options of `enfilade fly`, e.g. --tolerance 0.1 --frames 0..59
# LABELS    optional: labels of the test
#
# Where frames differ the test fails, and an HTML page with the expected (as it was recorded), actual and difference
# pictures is left in the build folder, flythroughs/NAME/. The command is
# the target Enfilade::enfilade where there is one, else the installed program.
function(enfilade_add_flythrough_test)
  cmake_parse_arguments(arg "" "NAME;SCRIPT;AGAINST" "OPTIONS;LABELS" ${ARGN})
  foreach(needed NAME SCRIPT)
    if(NOT arg_${needed})
      message(FATAL_ERROR "enfilade_add_flythrough_test: expected ${needed}")
    endif()
  endforeach()
  get_filename_component(script "${arg_SCRIPT}" ABSOLUTE)
  if(NOT EXISTS "${script}")
    message(FATAL_ERROR "enfilade_add_flythrough_test: there is no script ${script}")
  endif()
  if(TARGET Enfilade::enfilade)
    set(command $<TARGET_FILE:Enfilade::enfilade>)
  else()
    find_program(ENFILADE_COMMAND enfilade REQUIRED)
    set(command ${ENFILADE_COMMAND})
  endif()
  if(arg_AGAINST)
    list(PREPEND arg_OPTIONS --against ${arg_AGAINST})
  endif()
  add_test(NAME ${arg_NAME} COMMAND ${command} fly ${script} --check --out
                                    ${CMAKE_CURRENT_BINARY_DIR}/flythroughs/${arg_NAME} ${arg_OPTIONS})
  set_tests_properties(${arg_NAME} PROPERTIES LABELS "flythrough;${arg_LABELS}" TIMEOUT 600)
endfunction()
