# The curve room as a library for other programs, static and shared, with a CMake package (docs/curve_library.md):
#   cmake -B build -DCOASTER_CURVE_LIBRARY=ON && cmake --build build --target curve_static curve_shared
#   cmake --install build --component curve_library --prefix X
# Its component is not part of a plain installation or of the packages.
option(COASTER_CURVE_LIBRARY "Build the curve library for other programs, too (docs/curve_library.md)" OFF)
if(EMSCRIPTEN OR COASTER_SANITIZE OR NOT (COASTER_CURVE_LIBRARY OR BUILD_TESTING))
  return()
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(curve_generated ${CMAKE_BINARY_DIR}/generated/curve_library)

# Its headers: all others of the room are parts of it. The test tool.curve_library checks what they include.
set(curve_headers arc_length arc_length_study bernstein carried_frame continuity cubic evaluators frames g2 kernels
                  natural_spline quadrature span_fit tight_places)
list(TRANSFORM curve_headers REPLACE "(.+)" "curve/\\1.h")
# What it needs of base. Static: the room's objects, which the program links, too.
set(curve_base ${CMAKE_SOURCE_DIR}/src/base/library_check.cpp ${CMAKE_SOURCE_DIR}/src/base/portable_math.cpp)
add_library(curve_static STATIC $<TARGET_OBJECTS:coaster_curve> ${curve_base})

# Shared: compiled again, for any address, and most of it at once. It exports what its headers declare and nothing else:
# they are included first, with default visibility. The kernels share no code with other sources, not even inline
# functions, so they include none of them.
set(curve_exports ${curve_generated}/exports.h)
list(TRANSFORM curve_headers REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE curve_includes)
string(CONCAT curve_includes "#pragma once\n#include <glm/glm.hpp>\n#pragma GCC visibility push(default)\n"
              ${curve_includes} "#pragma GCC visibility pop\n")
file(CONFIGURE OUTPUT ${curve_exports} CONTENT "${curve_includes}" @ONLY)
file(GLOB curve_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/curve/*.cpp)
set(curve_kernels ${curve_sources})
list(FILTER curve_kernels INCLUDE REGEX "/kernels_[^/]*$")
list(REMOVE_ITEM curve_sources ${curve_kernels})
add_library(curve_kernels OBJECT ${curve_kernels})
add_library(curve_shared SHARED ${curve_sources} ${curve_base} $<TARGET_OBJECTS:curve_kernels>)
coaster_unity(curve_shared 40)
target_compile_options(curve_shared PRIVATE -include ${curve_exports} -Wno-shadow -fno-semantic-interposition)
# Also hides the standard library's templates.
target_link_options(curve_shared PRIVATE LINKER:--version-script=${CMAKE_CURRENT_LIST_DIR}/curve_library.map
                                         LINKER:--no-undefined)
set_target_properties(curve_shared PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LINK_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/curve_library.map)
set_target_properties(curve_kernels curve_shared PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
                                                            VISIBILITY_INLINES_HIDDEN ON)
foreach(target curve_static curve_kernels curve_shared)
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/src)
endforeach()

# Programs include <coaster/curve/cubic.h>; the headers include each other as "curve/cubic.h".
foreach(kind static shared)
  set_target_properties(curve_${kind} PROPERTIES
    OUTPUT_NAME coaster_curve EXPORT_NAME ${kind} ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/curve_library
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/curve_library)
  target_include_directories(curve_${kind} INTERFACE
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/coaster>)
  target_link_libraries(curve_${kind} PUBLIC glm::glm)
  target_compile_features(curve_${kind} INTERFACE cxx_std_20)
endforeach()

set(curve_package ${CMAKE_INSTALL_LIBDIR}/cmake/coaster_curve)
set(curve_docs ${CMAKE_INSTALL_DATADIR}/doc/coaster_curve)
write_basic_package_version_file(${curve_generated}/coaster_curveConfigVersion.cmake COMPATIBILITY SameMinorVersion)
# curve_install(WHAT ...): install() with the library's component.
macro(curve_install)
  install(${ARGN} COMPONENT curve_library EXCLUDE_FROM_ALL)
endmacro()
install(TARGETS curve_static curve_shared EXPORT coaster_curve
        ARCHIVE COMPONENT curve_library EXCLUDE_FROM_ALL
        LIBRARY COMPONENT curve_library NAMELINK_COMPONENT curve_library EXCLUDE_FROM_ALL)
curve_install(EXPORT coaster_curve NAMESPACE coaster_curve:: FILE coaster_curveTargets.cmake
              DESTINATION ${curve_package})
curve_install(FILES cmake/coaster_curveConfig.cmake ${curve_generated}/coaster_curveConfigVersion.cmake
              DESTINATION ${curve_package})
list(TRANSFORM curve_headers PREPEND src/)
curve_install(FILES ${curve_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/coaster/curve)
curve_install(FILES LICENSE DESTINATION ${curve_docs})
curve_install(FILES docs/curve_library.md DESTINATION ${curve_docs} RENAME README.md)
curve_install(DIRECTORY tests/curve_library/ DESTINATION ${curve_docs}/examples)
