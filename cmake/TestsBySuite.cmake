# The tests of a googletest program, one of CTest's per suite: what the tests of a suite share is made once, and a
# program of many tests is started a few times. googletest's own module knows single tests only.
if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests "--gtest_filter=-${EXCEPT}" OUTPUT_VARIABLE listed
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "\n[^ \n]+\\." suites "\n${listed}")
  set(text "")
  foreach(suite ${suites})
    string(REGEX REPLACE "^\n(.*)\\.$" "\\1" suite "${suite}")
    string(APPEND text "add_test([[${LABEL}.${suite}]] [[${PROGRAM}]] [[--gtest_filter=${suite}.*-${EXCEPT}]])\n"
                       "set_tests_properties([[${LABEL}.${suite}]] PROPERTIES LABELS ${LABEL} TIMEOUT 300)\n")
  endforeach()
  file(WRITE ${FILE} "${text}")
  return()
endif()

# stria_tests_by_suite(PROGRAM LABEL EXCEPT): names and label of the tests; a filter of googletest's of what is left out.
set(stria_tests_by_suite_script ${CMAKE_CURRENT_LIST_FILE})
function(stria_tests_by_suite program label except)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/${program}_suites.cmake)
  add_custom_command(
    TARGET ${program} POST_BUILD VERBATIM
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${program}> -DLABEL=${label} -DEXCEPT=${except} -DFILE=${file}
            -P ${stria_tests_by_suite_script})
  if(NOT EXISTS ${file})
    file(WRITE ${file} "add_test(${program}_NOT_BUILT ${program}_NOT_BUILT)\n")
  endif()
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${file})
endfunction()
