# Tests of the build for browsers, label web: the page in Chromium, its scripts, and the core's tests, compiled by
# Emscripten and run by node with the same expected hashes. web/native_alone.txt lists the tests of the core that are
# left out.
find_program(NODE node REQUIRED)
set(left_out ${CMAKE_CURRENT_SOURCE_DIR}/web/native_alone.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${left_out})
file(STRINGS ${left_out} native_sources REGEX "_test\\.cpp$")
file(STRINGS ${left_out} native_names REGEX "^[A-Za-z0-9_]+\\.[a-z0-9_]*\\*?$")
set(sources)
foreach(room base curve world sim exchange edit view query)
  file(GLOB_RECURSE room_sources RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS
       ${CMAKE_CURRENT_SOURCE_DIR}/${room}/*_test.cpp)
  list(APPEND sources ${room_sources})
endforeach()
list(REMOVE_ITEM sources ${native_sources})

add_executable(core_tests ${sources})
target_include_directories(core_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_definitions(core_tests PRIVATE COASTER_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
target_link_libraries(core_tests PRIVATE coaster_query GTest::gtest_main)
target_compile_options(core_tests PRIVATE -O0)  # tests compile fast; the rooms keep their own options
if(COASTER_UNITY)
  coaster_unity(core_tests 16)
endif()
# The machine's own files and a stack as on Linux.
target_link_options(core_tests PRIVATE -O1 -sNODERAWFS=1 -sEXIT_RUNTIME=1 -sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=8MB)

# Node does not pass the environment on, in which GoogleTest looks for the part to run: filters choose it.
list(JOIN native_names ":" unlike)
# Emscripten 3.1 expects another fetch than that of new versions of node.
set(core ${NODE} --no-experimental-fetch --stack-size=4000 $<TARGET_FILE:core_tests>)
# Parts of about the same length, by the first letters of the suites; the last one runs all others.
set(part 0)
set(taken "")
foreach(letters ABCDEFGHIJKLMNO PQRSTUVWXYZ abcde others)
  math(EXPR part "${part} + 1")
  if(letters STREQUAL "others")
    set(filter "-${taken}${unlike}")
  else()
    string(REGEX REPLACE "(.)" "\\1*:" suites ${letters})
    string(APPEND taken ${suites})
    set(filter "${suites}-${unlike}")
  endif()
  add_test(NAME web.core.${part} COMMAND ${core} --gtest_filter=${filter})
  set_tests_properties(web.core.${part} PROPERTIES LABELS web TIMEOUT 1200 COST 200)
endforeach()

# The scripts run in parts side by side (ctest -j).
set(parts 4)
if(COASTER_APP)
  # The page, and one that runs scripts: files.data holds the files that they read, in /src.
  set(page $<TARGET_FILE_DIR:coaster>)
  set(files)
  foreach(folder tests/scripts tests/tracks tests/exchange tracks tutorials challenges envelopes)
    list(APPEND files ${CMAKE_SOURCE_DIR}/${folder}@/src/${folder})
  endforeach()
  add_custom_target(web_tests
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${CMAKE_BINARY_DIR}/test_page
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${page} ${CMAKE_BINARY_DIR}/test_page
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/web/script.html
            ${CMAKE_CURRENT_SOURCE_DIR}/web/scripts.html ${CMAKE_BINARY_DIR}/test_page
    COMMAND ${CMAKE_COMMAND} -E chdir ${CMAKE_BINARY_DIR}/test_page
            /usr/bin/python3 ${EMSCRIPTEN_ROOT_PATH}/tools/file_packager.py files.data
            --preload ${files} --js-output=files.js
    VERBATIM)
  add_dependencies(web_tests coaster)
  # coaster_web_test(NAME FILE [argument ...]): a test in Chromium. Debian's Python: it has Selenium.
  function(coaster_web_test name file)
    add_test(NAME web.${name} COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/web/${file}_test.py
                                      ${CMAKE_BINARY_DIR}/test_page ${CMAKE_SOURCE_DIR} ${ARGN})
    set_tests_properties(web.${name} PROPERTIES LABELS web TIMEOUT 1200)
  endfunction()
  foreach(part RANGE 1 ${parts})
    coaster_web_test(scripts.${part} scripts ${part}/${parts})
  endforeach()
  # Each test of a page has its own browser.
  foreach(file page kept work limits)
    file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/web/${file}_test.py lines REGEX "^(class|    def test_)")
    foreach(line ${lines})
      if(line MATCHES "^class ([A-Za-z]+)")
        set(class ${CMAKE_MATCH_1})
      elseif(line MATCHES "def test_([a-z0-9_]+)")
        coaster_web_test(${file}.${CMAKE_MATCH_1} ${file} ${class}.test_${CMAKE_MATCH_1})
      endif()
    endforeach()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/web/${file}_test.py)
  endforeach()
  set_tests_properties(web.limits.what_it_costs PROPERTIES RUN_SERIAL ON)  # it measures
  # The longest tests start first.
  set_tests_properties(web.work.ten_minutes_of_ride_take_no_memory web.page.random_input_breaks_nothing
                       PROPERTIES COST 100)
  set_tests_properties(web.page.a_circuit_built_by_hand_is_ridden_and_there_after_a_reload PROPERTIES COST 90)
endif()
