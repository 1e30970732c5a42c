# Read by CPack for each kind of package. The archive contains the libraries that the program links, in lib/coaster; the
# Debian package depends on theirs instead.
if(CPACK_GENERATOR STREQUAL "TGZ")
  list(GET CPACK_INSTALL_CMAKE_PROJECTS 0 build_folder)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${build_folder};coaster;libraries;/")
endif()
