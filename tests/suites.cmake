# The tests of a program, for ctest, which reads this when it starts: one for each suite that the program lists. A suite
# of `by_test` takes long, so it is a ctest test for each TEST, and these start first.
#
# Included with `name`, `program`, `by_test` and `environment` set.
cmake_minimum_required(VERSION 3.25)

# In the list a suite is a line that ends with a dot, and its tests are indented below. Behind # are types and values; a
# suite that has several is one ctest test: Bounds/0 and Bounds/1 are Bounds, Cases/StressCatalogue is StressCatalogue.
execute_process(COMMAND ${program} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE status)
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")
string(REPLACE "\n" ";" lines "${listed}")
set(tests)
foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Za-z0-9_]+/)?([A-Za-z_][A-Za-z0-9_]*)(/[0-9]+)?\\.$")
    set(suite ${CMAKE_MATCH_2})
    if(NOT suite IN_LIST by_test)
      list(APPEND tests ${suite})
    endif()
  elseif(line MATCHES "^  ([A-Za-z0-9_]+)$" AND suite IN_LIST by_test)
    list(APPEND tests ${suite}.${CMAKE_MATCH_1})
  endif()
endforeach()
list(REMOVE_DUPLICATES tests)

# A program that was not built, or lists nothing, is a test that fails.
if(NOT tests OR NOT status EQUAL 0)
  add_test(${name} ${name}-lists-no-tests)
endif()

foreach(test IN LISTS tests)
  if(test MATCHES "\\.")
    set(filter ${test})
    set(cost 100)
  else()
    set(filter ${test}.*:${test}/*:*/${test}.*)
    set(cost 0)
  endif()
  add_test(${test} ${program} --gtest_filter=${filter})
  set_tests_properties(${test} PROPERTIES ENVIRONMENT "${environment}" COST ${cost}
    FAIL_REGULAR_EXPRESSION "Running 0 tests from 0 test suites")
endforeach()
