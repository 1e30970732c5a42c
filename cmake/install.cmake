# Installation: cmake --install build/release --prefix X; and the packages that CPack builds from it (tools/package).
include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # cpack packs an existing build; tools/package builds first
set(COASTER_ID org.coaster_builder.coaster CACHE STRING "Name of launcher, icon and AppStream entry")
set(COASTER_GENERATED ${CMAKE_BINARY_DIR}/generated)

# The archive contains its libraries next to the program (cmake/package.cmake).
set_target_properties(coaster PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/coaster")
install(TARGETS coaster RUNTIME_DEPENDENCY_SET coaster_libraries RUNTIME)
install(RUNTIME_DEPENDENCY_SET coaster_libraries
        PRE_EXCLUDE_REGEXES "ld-linux|lib(c|m|dl|rt|pthread|gcc_s|stdc\\+\\+|asound|X[^.]*|xcb[^.]*|GL[^.]*)[.]so"
        LIBRARY DESTINATION lib/coaster COMPONENT libraries EXCLUDE_FROM_ALL)
foreach(data tracks envelopes challenges tutorials)
  if(IS_DIRECTORY ${CMAKE_SOURCE_DIR}/${data})
    # Tracks that are open have locks beside them.
    install(DIRECTORY ${data} DESTINATION ${CMAKE_INSTALL_DATADIR}/coaster PATTERN "*.lock" EXCLUDE)
  endif()
endforeach()
install(FILES README.md CHANGELOG.md CONTRIBUTING.md packaging/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
        FILES_MATCHING PATTERN "*.md" PATTERN "*.coaster" PATTERN "*.png" PATTERN "*.svg")

# The program prints the manual page and the completion, from the table that parses its options.
add_custom_command(
  OUTPUT ${COASTER_GENERATED}/coaster.6 ${COASTER_GENERATED}/coaster.bash
  COMMAND coaster --help-man > ${COASTER_GENERATED}/coaster.6
  COMMAND coaster --help-completion > ${COASTER_GENERATED}/coaster.bash
  DEPENDS coaster COMMENT "Printing the manual page and the completion" VERBATIM)
add_custom_target(coaster_manual ALL DEPENDS ${COASTER_GENERATED}/coaster.6 ${COASTER_GENERATED}/coaster.bash)
install(FILES ${COASTER_GENERATED}/coaster.6 DESTINATION ${CMAKE_INSTALL_MANDIR}/man6)
install(FILES ${COASTER_GENERATED}/coaster.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME coaster)

# Desktop integration: a launcher, an icon, an AppStream entry.
configure_file(packaging/coaster.desktop.in ${COASTER_GENERATED}/${COASTER_ID}.desktop @ONLY)
configure_file(packaging/coaster.metainfo.xml.in ${COASTER_GENERATED}/${COASTER_ID}.metainfo.xml @ONLY)
install(FILES ${COASTER_GENERATED}/${COASTER_ID}.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${COASTER_GENERATED}/${COASTER_ID}.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES packaging/coaster.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps
        RENAME ${COASTER_ID}.svg)

set(CPACK_PACKAGE_NAME coaster)
set(CPACK_PACKAGE_VENDOR "The coaster authors")
set(CPACK_PACKAGE_CONTACT "The coaster authors <authors@coaster.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "roller-coaster builder and laboratory of cubic Bezier curves")
string(CONCAT CPACK_PACKAGE_DESCRIPTION
       "Build a roller coaster from piecewise cubic Bezier curves, ride it, and see at every moment how such curves "
       "are evaluated, measured, framed and ridden. Runs in a window and, by script, without a display.")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_FILE_NAME coaster-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION games)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # linked libraries
set(CPACK_DEBIAN_PACKAGE_DEPENDS libgl1)  # and loaded ones: OpenGL, by GLFW,
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libosmesa6 | libegl1, libgl1-mesa-dri, libfontconfig1")  # --headless, letters
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, zenity")                 # movie files, the desktop's file dialog
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_SOURCE_DIR}/cmake/package.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/cmake/package_files.cmake)
include(CPack)
