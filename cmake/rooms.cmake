# coaster_room(NAME [COLD] [USES room ...] [LINK library ...])
# One static library coaster_NAME from the .cpp files in and below src/NAME. Rooms include each other's headers as
# "room/file.h"; tools/check_layers checks which room may include which. COLD: optimised builds compile it with -O1, in
# two thirds of -O2's time, tests with sanitizers with -O0, in two fifths. The speed of such rooms does not matter: they
# wait for people and files. Only fuzzing reads as many files as it can.

# Precompiled headers of the standard library, GLM and fmt save a third of a file's compile time. "rooms" adds the
# project's headers that include most others and saves a quarter of the rest, but when one of them changes, everything
# is compiled anew. Sources nevertheless include what they need; clang-tidy (tools/lint) reads them without. Each
# optimisation level has its own precompiled header, because it must have the level of the sources.
# coaster_precompile(TARGET OPTIONS header ...) adds OPTIONS to TARGET and to its precompiled header, which with "rooms"
# includes these headers.
set(COASTER_PRECOMPILE libraries CACHE STRING
    "Precompile headers: OFF, libraries or rooms. With rooms whole suites build sooner, single changes later")
set(CMAKE_PCH_PROLOGUE "")  # CMake's would declare them the system's, which compilers do not warn about
function(coaster_precompile target options)
  target_compile_options(${target} PRIVATE ${options})
  if(NOT COASTER_PRECOMPILE)
    return()
  endif()
  string(MAKE_C_IDENTIFIER "coaster_headers${options}" headers)
  if(NOT TARGET ${headers})
    set(empty ${CMAKE_BINARY_DIR}/precompiled.cpp)
    file(WRITE ${empty} "")
    add_library(${headers} OBJECT ${empty})
    target_compile_options(${headers} PRIVATE ${options})
    target_include_directories(${headers} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
    target_link_libraries(${headers} PRIVATE glm::glm coaster_fmt $<TARGET_NAME_IF_EXISTS:coaster_imgui>)
    target_precompile_headers(${headers} PRIVATE
      <algorithm> <array> <cmath> <cstdint> <cstdio> <deque> <filesystem> <functional> <map> <memory> <optional> <set>
      <span> <string> <string_view> <tuple> <utility> <variant> <vector> <fmt/format.h> <glm/glm.hpp>)
    if(COASTER_PRECOMPILE STREQUAL "rooms")
      list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/src/)
      target_precompile_headers(${headers} PRIVATE ${ARGN})
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${headers})
endfunction()

# Compiles up to `most` sources of a target as one in builds of the whole suite. Names in unnamed namespaces must
# therefore be unique in their room.
function(coaster_unity target most)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${most})
endfunction()

# For sources that are hardly optimised: gcc collects garbage only after allocating this much memory (kB), which saves
# up to a sixth of its time.
function(coaster_compile_fast target)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=600000>)
endfunction()

# Links the rooms that compute before everything else. An inline function is compiled in every file that calls it, and
# the linker keeps the first copy: an optimised one, although those of tests and COLD rooms may not be.
function(coaster_link_optimised_first target)
  foreach(room base curve world sim)
    target_link_options(${target} PRIVATE
      "SHELL:LINKER:--whole-archive $<TARGET_FILE:coaster_${room}> LINKER:--no-whole-archive")
  endforeach()
endfunction()

function(coaster_room name)
  cmake_parse_arguments(room "COLD" "" "USES;LINK" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/app/main\\.cpp$|/base/library_check\\.cpp$")
  # A web page has no threads, signals, processes, other programs or displays: web_*.cpp and no_*.cpp replace them.
  if(EMSCRIPTEN)
    list(FILTER sources EXCLUDE REGEX "/base/(parallel|crash_guard)\\.cpp$")
    list(FILTER sources EXCLUDE REGEX "/app/(process|job_thread)\\.cpp$")
    list(FILTER sources EXCLUDE REGEX "/platform/(offscreen|glfw)_.*\\.cpp$")
    list(FILTER sources EXCLUDE REGEX "/platform/(desktop|no_window)\\.cpp$")
  else()
    list(FILTER sources EXCLUDE REGEX "/base/no_system\\.cpp$|/web_[a-z]+\\.cpp$")
  endif()
  if(COASTER_WINDOW)
    list(FILTER sources EXCLUDE REGEX "/platform/no_window\\.cpp$")
  else()
    list(FILTER sources EXCLUDE REGEX "/platform/glfw_.*\\.cpp$")
  endif()
  if(TARGET coaster_openal)
    list(FILTER sources EXCLUDE REGEX "/platform/no_sound\\.cpp$")
  else()
    list(FILTER sources EXCLUDE REGEX "/platform/openal_.*\\.cpp$")
  endif()
  add_library(coaster_${name} STATIC ${sources})
  target_include_directories(coaster_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/src)
  list(TRANSFORM room_USES PREPEND coaster_)
  target_link_libraries(coaster_${name} PUBLIC ${room_USES} ${room_LINK})
  # What a page loads should be small: a ride's frame takes a tenth of the time that it may there.
  if(EMSCRIPTEN AND (room_COLD OR name MATCHES "^(base|world|gfx|view)$"))
    coaster_precompile(coaster_${name} -Oz)
  elseif(room_COLD AND COASTER_SANITIZE AND NOT COASTER_FUZZ)
    coaster_precompile(coaster_${name} -O0)
  elseif(room_COLD AND CMAKE_BUILD_TYPE STREQUAL "Release")
    coaster_precompile(coaster_${name} -O1 ui/context/ui.h edit/perform/perform_context.h)
    coaster_compile_fast(coaster_${name})
  else()
    coaster_precompile(coaster_${name} "" sim/shape/derived_track.h sim/ride/ride.h)
  endif()
  if(EMSCRIPTEN)  # what is built once for a change of the track, or asked for by people
    list(FILTER sources INCLUDE REGEX
         "/sim/(ground/(brush|fixtures|lamps|land_mesh|land_paint|meadow|plant_models|tunnel_mesh)|\
solids/(coaster_form|mesh|station_mesh|supports|train_mesh)|\
study/(colour_values|evaluator_benchmark|force_limits|jolt|ratings|riders|track_errata))\\.cpp$")
    set_source_files_properties(${sources} PROPERTIES
      COMPILE_OPTIONS -Oz SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  if(COASTER_UNITY STREQUAL "all")
    coaster_unity(coaster_${name} 40)
    # A local may have the name of a constant in another file.
    target_compile_options(coaster_${name} PRIVATE -Wno-shadow)
  endif()
endfunction()
