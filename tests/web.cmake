# Tests of the build for browsers, label web: the page in Chromium, its scripts, and the core's tests, compiled by
# Emscripten and run by node with the same expected hashes. Those that use RapidCheck, processes or threads run natively alone: RapidCheck is installed for this machine, and
# a page has none of the others.
find_program(NODE node REQUIRED)
set(sources)
foreach(room base curve world sim exchange edit view query)
  file(GLOB_RECURSE room_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${room}/*_test.cpp)
  foreach(source ${room_sources})
    file(STRINGS ${source} native REGEX "rapidcheck|EXPECT_EXIT|EXPECT_DEATH|fork\\(|std::j?thread" LIMIT_COUNT 1)
    if(NOT native)
      list(APPEND sources ${source})
    endif()
  endforeach()
endforeach()

add_executable(core_tests ${sources})
target_include_directories(core_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_definitions(core_tests PRIVATE COASTER_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
target_link_libraries(core_tests PRIVATE coaster_query GTest::gtest_main)
target_compile_options(core_tests PRIVATE -O1)
if(COASTER_UNITY)
  coaster_unity(core_tests 16)
endif()
# The machine's own files and a stack as on Linux.
target_link_options(core_tests PRIVATE -sNODERAWFS=1 -sEXIT_RUNTIME=1 -sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=8MB)

# Not run: for node a name of a file is text, not any bytes, and it follows links and pipes in another way (TrackFile,
# folders, root); an oracle of quadrature has other digits in a long double of 128 bits.
string(JOIN ":" unlike TrackFile.a_name_from_a_files_name_can_be_kept_in_any_file folders.folders_come_first* root.*
       quadrature.gauss_legendre_is_exact*)
# Emscripten 3.1 expects another fetch than that of new versions of node.
add_test(NAME web.core COMMAND ${NODE} --no-experimental-fetch --stack-size=4000 $<TARGET_FILE:core_tests> --gtest_filter=-${unlike})
set_tests_properties(web.core PROPERTIES LABELS web TIMEOUT 600)

if(COASTER_APP)
  # The page, and one that runs scripts: files.data holds the files that they read, in /src.
  set(page $<TARGET_FILE_DIR:coaster>)
  set(files)
  foreach(folder tests/scripts tests/tracks tests/exchange tracks tutorials challenges envelopes docs)
    list(APPEND files ${CMAKE_SOURCE_DIR}/${folder}@/src/${folder})
  endforeach()
  add_custom_target(web_tests
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${CMAKE_BINARY_DIR}/test_page
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${page} ${CMAKE_BINARY_DIR}/test_page
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/web/script.html ${CMAKE_BINARY_DIR}/test_page
    COMMAND ${CMAKE_COMMAND} -E chdir ${CMAKE_BINARY_DIR}/test_page /usr/bin/python3 ${EMSCRIPTEN_ROOT_PATH}/tools/file_packager.py files.data
            --preload ${files} --js-output=files.js
    VERBATIM)
  add_dependencies(web_tests coaster)
  foreach(test scripts page)
    # Debian's Python: it has Selenium.
    add_test(NAME web.${test} COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/web/${test}_test.py ${CMAKE_BINARY_DIR}/test_page ${CMAKE_SOURCE_DIR})
    set_tests_properties(web.${test} PROPERTIES LABELS web TIMEOUT 900)
  endforeach()
endif()
