# Sets COASTER_VERSION_DATE to the date of the version's entry in CHANGELOG.md, "## 0.1.0 - 2026-11-21". A version
# without an entry is an error.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/CHANGELOG.md)
file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/CHANGELOG.md coaster_entry
     REGEX "^## ${PROJECT_VERSION} - [0-9]+-[0-9]+-[0-9]+$" LIMIT_COUNT 1)
if(NOT coaster_entry)
  message(FATAL_ERROR
    "CHANGELOG.md has no line \"## ${PROJECT_VERSION} - YEAR-MONTH-DAY\": the version in CMakeLists.txt wants an entry")
endif()
string(REGEX REPLACE "^.* - " "" COASTER_VERSION_DATE "${coaster_entry}")
