# find_package(coaster_curve) gives these targets:
#   coaster_curve::static         the static library
#   coaster_curve::shared         the shared library
#   coaster_curve::coaster_curve  the shared one if BUILD_SHARED_LIBS is on, else the static one
find_package(glm QUIET CONFIG)
if(NOT TARGET glm::glm)
  find_path(coaster_curve_GLM_INCLUDE glm/glm.hpp)
  if(NOT coaster_curve_GLM_INCLUDE)
    set(coaster_curve_FOUND FALSE)
    set(coaster_curve_NOT_FOUND_MESSAGE "GLM was not found. Install it with: apt-get install libglm-dev (Debian)")
    return()
  endif()
  add_library(glm::glm INTERFACE IMPORTED)
  target_include_directories(glm::glm SYSTEM INTERFACE ${coaster_curve_GLM_INCLUDE})
endif()
include(${CMAKE_CURRENT_LIST_DIR}/coaster_curveTargets.cmake)
if(NOT TARGET coaster_curve::coaster_curve)
  add_library(coaster_curve::coaster_curve INTERFACE IMPORTED)
  if(BUILD_SHARED_LIBS)
    target_link_libraries(coaster_curve::coaster_curve INTERFACE coaster_curve::shared)
  else()
    target_link_libraries(coaster_curve::coaster_curve INTERFACE coaster_curve::static)
  endif()
endif()
