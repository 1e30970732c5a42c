# The libraries of the build for browsers (preset web; tools/web). Those of headers alone are the installed ones: each
# is linked into its own folder, because the other headers of /usr/include belong to another system. TinyXML-2, zlib and
# Dear ImGui are compiled from the sources in COASTER_WEB_SOURCES. Its folders have the names that apt-get source gives
# them: tinyxml2-*, zlib-*, imgui-*.
set(COASTER_WEB_SOURCES "" CACHE PATH
    "Folder of the sources of Dear ImGui, TinyXML-2 and zlib (tools/web fetches them)")

enable_language(C)  # zlib

# coaster_headers(TARGET WHAT PACKAGE LICENCE PATH...): an interface library of headers below /usr/include.
function(coaster_headers target what package licence)
  string(MAKE_C_IDENTIFIER ${target} name)
  set(folder ${CMAKE_BINARY_DIR}/include/${name})
  foreach(path ${ARGN})
    if(NOT EXISTS /usr/include/${path})
      coaster_missing("${what}" ${package})
    endif()
    cmake_path(GET path PARENT_PATH above)
    file(MAKE_DIRECTORY ${folder}/${above})
    file(CREATE_LINK /usr/include/${path} ${folder}/${path} SYMBOLIC)
  endforeach()
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${folder})
  coaster_found("${what}" "" "${licence}")
endfunction()

# coaster_sources(TARGET WHAT FOLDER FILE...): a static library of the files in the one folder of that pattern.
function(coaster_sources target what pattern)
  file(GLOB folder LIST_DIRECTORIES true ${COASTER_WEB_SOURCES}/${pattern})
  list(FILTER folder EXCLUDE REGEX "\\.(dsc|xz|gz|bz2|log)$")
  list(LENGTH folder count)
  if(NOT COASTER_WEB_SOURCES OR NOT count EQUAL 1)
    message(FATAL_ERROR
      "${what}: expected one folder ${pattern} in COASTER_WEB_SOURCES (${COASTER_WEB_SOURCES}), found ${count}. "
      "tools/web fetches it")
  endif()
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE files)
  file(GLOB sources ${files})
  add_library(${target} STATIC ${sources})
  target_include_directories(${target} SYSTEM PUBLIC ${folder})
  target_compile_options(${target} PRIVATE -w)
  coaster_found("${what}" "${folder}" "compiled for browsers")
endfunction()

coaster_headers(glm::glm "GLM" libglm-dev "MIT" glm)
coaster_headers(xxhash::xxhash "xxHash" libxxhash-dev "BSD-2-Clause" xxhash.h)
target_compile_definitions(xxhash::xxhash INTERFACE XXH_INLINE_ALL)
coaster_headers(coaster_fmt "fmt" libfmt-dev "MIT" fmt)
target_compile_definitions(coaster_fmt INTERFACE FMT_HEADER_ONLY)
coaster_headers(FastFloat::fast_float "fast_float" libfast-float-dev "Apache-2.0 or MIT" fast_float)
coaster_headers(nlohmann_json::nlohmann_json "nlohmann JSON" nlohmann-json3-dev "MIT" nlohmann)
coaster_sources(coaster_zlib "zlib" zlib-* adler32.c crc32.c deflate.c inffast.c inflate.c inftrees.c trees.c zutil.c)
add_library(ZLIB::ZLIB ALIAS coaster_zlib)
coaster_sources(coaster_tinyxml2 "TinyXML-2" tinyxml2-* tinyxml2.cpp)

if(COASTER_APP)
  coaster_headers(CLI11::CLI11 "CLI11" libcli11-dev "BSD-3-Clause" CLI)
  coaster_headers(coaster_opengl "OpenGL core header" libgl-dev "MIT" GL/glcorearb.h KHR)
  coaster_headers(coaster_stb "stb" libstb-dev "MIT or public domain" stb)
  target_include_directories(coaster_stb SYSTEM INTERFACE ${CMAKE_BINARY_DIR}/include/coaster_stb/stb)
  coaster_sources(coaster_imgui "Dear ImGui" imgui-* imgui*.cpp)
  add_library(coaster_openal INTERFACE)  # Emscripten's own, on Web Audio
  target_link_libraries(coaster_openal INTERFACE openal)
  find_file(COASTER_INTER_FONT NAMES Inter-Regular.otf PATHS /usr/share/fonts/opentype/inter
            NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
endif()

if(BUILD_TESTING)
  # RapidCheck has no installed sources: tests that use it run natively alone.
  set(googletest /usr/src/googletest/googletest)
  if(NOT EXISTS ${googletest}/src/gtest-all.cc)
    coaster_missing("the sources of GoogleTest" googletest)
  endif()
  add_library(coaster_gtest STATIC ${googletest}/src/gtest-all.cc ${googletest}/src/gtest_main.cc)
  target_include_directories(coaster_gtest SYSTEM PUBLIC ${googletest}/include PRIVATE ${googletest})
  target_compile_options(coaster_gtest PRIVATE -w)
  add_library(GTest::gtest_main ALIAS coaster_gtest)
  coaster_found("GoogleTest" "${googletest}" "BSD-3-Clause")
endif()
