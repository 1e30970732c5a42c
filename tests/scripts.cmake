# Each tests/scripts/*.coaster is a test: it runs headless and must end with exit code 0.
file(GLOB scripts CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/scripts/*.coaster)
function(coaster_script_test name)
  add_test(NAME script.${name} COMMAND ${ARGN} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  set_tests_properties(script.${name} PROPERTIES LABELS script ENVIRONMENT "${hermetic}" SKIP_RETURN_CODE 77
                                                 TIMEOUT 300)
endfunction()
# Runs a script headless with these environment variables. Its pictures go to a folder of the test's name.
function(coaster_headless_test name script)
  string(REPLACE . _ folder ${name})
  coaster_script_test(${name} ${CMAKE_COMMAND} -E env ${ARGN} $<TARGET_FILE:coaster> --headless --script ${script}
                      --out ${CMAKE_CURRENT_BINARY_DIR}/out/${folder})
endfunction()
foreach(script ${scripts})
  cmake_path(GET script STEM name)
  coaster_headless_test(${name} ${script})
  file(STRINGS ${script} golden_pictures REGEX "^snap ")
  if(golden_pictures AND second_headless)
    coaster_headless_test(${name}.egl ${script} ${second_headless})
  endif()
  if(golden_pictures AND browser_headless)
    coaster_headless_test(${name}.gles ${script} ${browser_headless})
  endif()
endforeach()

# The script counts the pictures in its folder, so it starts with an empty one.
add_test(NAME script.window_states.empty
         COMMAND ${CMAKE_COMMAND} -E rm -rf ${CMAKE_CURRENT_BINARY_DIR}/out/window_states)
set_tests_properties(script.window_states.empty PROPERTIES LABELS script FIXTURES_SETUP window_states_folder)
set_tests_properties(script.window_states PROPERTIES FIXTURES_REQUIRED window_states_folder)

# Each challenge must fail on its start track (--validate) and pass with its solution.
file(GLOB challenges CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/challenges/*.json)
foreach(challenge ${challenges})
  cmake_path(GET challenge STEM name)
  coaster_script_test(challenge.${name}.fails $<TARGET_FILE:coaster> --validate ${challenge})
  coaster_headless_test(challenge.${name}.solution ${CMAKE_SOURCE_DIR}/challenges/solutions/${name}.coaster)
endforeach()

# The circuit of docs/play.md.
coaster_headless_test(play ${CMAKE_SOURCE_DIR}/docs/play.coaster)

# The tutorial's steps must work: without a player its lessons run their own lines.
file(GLOB tutorials CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tutorials/*.coaster)
foreach(script ${tutorials})
  cmake_path(GET script STEM name)
  coaster_headless_test(tutorial_${name} ${script})
endforeach()

# The command line: exit codes, recordings that replay to the same hashes, files validated without running.
set(failing_new)
set(failing_threads)
if(NOT COASTER_SANITIZE)  # sanitizers have their own allocator and pthread_create
  add_library(failing_new MODULE ${CMAKE_CURRENT_SOURCE_DIR}/app/failing_new.cpp)
  set(failing_new $<TARGET_FILE:failing_new>)
  add_library(failing_threads MODULE ${CMAKE_CURRENT_SOURCE_DIR}/app/failing_threads.cpp)
  set(failing_threads $<TARGET_FILE:failing_threads>)
endif()
file(GLOB checks CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/app/*_check.sh)
foreach(check ${checks})
  cmake_path(GET check STEM name)
  coaster_script_test(${name} ${CMAKE_COMMAND} -E env COASTER=$<TARGET_FILE:coaster>
                      OUT=${CMAKE_CURRENT_BINARY_DIR}/out/${name} SOURCE=${CMAKE_SOURCE_DIR} BUILD=${CMAKE_BINARY_DIR}
                      CMAKE=${CMAKE_COMMAND} FAILING_NEW=${failing_new} FAILING_THREADS=${failing_threads}
                      bash ${check})
  set_tests_properties(script.${name} PROPERTIES COST 20)  # the longest tests start first
endforeach()
