# A test that compares a trace with a stored one, its golden, and a target that writes the golden anew:
#
#     rastertrace_add_golden(first-triangle first-triangle.json KINDS primitive,scanline,pixel)
#     rastertrace_add_golden(mine COMMAND my_rasterizer scene.txt KINDS scanline,pixel TOLERANCE scanline=1e-6)
#
#     ctest -R first-triangle
#     cmake --build build --target renew-first-triangle     # or rastertrace-renew-goldens: all of them
#
# The first argument names the test. Then comes a scene, or COMMAND and a program (a target, or a path) that prints its
# trace. Names of files are relative to the current source folder; the program runs there, too. RASTERTRACE_RENEW=1 in
# the environment lets the test itself renew its golden.
#
#   GOLDEN file            the stored trace, NAME.golden.jsonl if not said
#   KINDS kind,...         only these kinds of step are stored and compared, and the header is not compared
#   TOLERANCE text...      how far numbers may differ, as for `rastertrace diff --tolerance`
#   IGNORE text,...        what is not compared, as for `rastertrace diff --ignore`
#   OPTIONS option...      of the program, for a scene: --fill top-left
#
# docs/regression-tests.md has an example of each.
function(rastertrace_add_golden name)
  cmake_parse_arguments(PARSE_ARGV 1 golden "" "GOLDEN" "COMMAND;KINDS;TOLERANCE;IGNORE;OPTIONS")
  if(golden_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "rastertrace_add_golden(${name}): expected a value behind ${golden_KEYWORDS_MISSING_VALUES}")
  endif()
  if(golden_COMMAND AND golden_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "rastertrace_add_golden(${name}): expected a scene or COMMAND, found both")
  elseif(NOT golden_COMMAND)
    list(LENGTH golden_UNPARSED_ARGUMENTS scenes)
    if(NOT scenes EQUAL 1)
      message(FATAL_ERROR "rastertrace_add_golden(${name}): expected one scene, or COMMAND, found ${scenes} scenes")
    endif()
  elseif(golden_OPTIONS)
    message(FATAL_ERROR "rastertrace_add_golden(${name}): expected OPTIONS with a scene, found them with COMMAND")
  endif()
  if(NOT golden_GOLDEN)
    set(golden_GOLDEN ${name}.golden.jsonl)
  endif()
  # A target is named by its folder, too: two folders may have a golden of one name.
  file(RELATIVE_PATH folder ${CMAKE_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REGEX REPLACE "[^A-Za-z0-9_.+-]+" "-" target "renew/${folder}/${name}")
  list(JOIN golden_KINDS "," kinds)
  list(JOIN golden_IGNORE "," ignored)
  list(JOIN golden_TOLERANCE "," tolerances)
  list(JOIN golden_OPTIONS " " options)

  set(command ${golden_COMMAND})
  if(command)
    list(POP_FRONT command program)
    if(TARGET ${program})
      set(program $<TARGET_FILE:${program}>)
    endif()
    list(PREPEND command ${program})
  endif()
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/golden-test.cmake)
  set(run ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:rastertrace::program> "-DGOLDEN=${golden_GOLDEN}"
    "-DSCENE=${golden_UNPARSED_ARGUMENTS}" -DKINDS=${kinds} -DIGNORED=${ignored}
    -DTOLERANCES=${tolerances} "-DOPTIONS=${options}"
    "-DTRACE=${CMAKE_CURRENT_BINARY_DIR}/${name}.trace"
    "-DRENEWED_BY=cmake --build ${CMAKE_BINARY_DIR} --target ${target}")

  add_test(NAME ${name} COMMAND ${run} -DMODE=compare -P ${script} -- ${command}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} COMMAND_EXPAND_LISTS)
  add_custom_target(${target}
    COMMAND ${run} -DMODE=renew -P ${script} -- ${command}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} COMMAND_EXPAND_LISTS VERBATIM
    COMMENT "Renewing ${golden_GOLDEN}")
  if(NOT TARGET rastertrace-renew-goldens)
    add_custom_target(rastertrace-renew-goldens)
  endif()
  add_dependencies(rastertrace-renew-goldens ${target})
endfunction()
