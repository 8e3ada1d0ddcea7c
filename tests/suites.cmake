# The tests of a program, for ctest, which reads this when it starts: one for each suite that the program lists.
#
# Included with `name`, `program`, `long_suites` and `environment` set.
cmake_minimum_required(VERSION 3.25)

# In the list a suite is a line that ends with a dot. Behind # is what type it is for; a suite for several types or
# values is one ctest test: Bounds/0 and Bounds/1 are Bounds, Cases/StressCatalogue is StressCatalogue.
execute_process(COMMAND ${program} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE status)
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")
string(REPLACE "\n" ";" lines "${listed}")
set(suites)
foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Za-z0-9_]+/)?([A-Za-z_][A-Za-z0-9_]*)(/[0-9]+)?\\.$")
    list(APPEND suites ${CMAKE_MATCH_2})
  endif()
endforeach()
list(REMOVE_DUPLICATES suites)

# A program that was not built, or lists nothing, is a test that fails.
if(NOT suites OR NOT status EQUAL 0)
  add_test(${name} ${name}-lists-no-tests)
endif()

foreach(suite IN LISTS suites)
  add_test(${suite} ${program} --gtest_filter=${suite}.*:${suite}/*:*/${suite}.*)
  set_tests_properties(${suite} PROPERTIES ENVIRONMENT "${environment}" TIMEOUT 3600
    FAIL_REGULAR_EXPRESSION "Running 0 tests from 0 test suites")
  if(suite IN_LIST long_suites)
    set_tests_properties(${suite} PROPERTIES COST 100) # starts early
  endif()
endforeach()
