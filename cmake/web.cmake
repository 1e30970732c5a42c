# The web page: index.html, and coaster.js, coaster.wasm and coaster.data, which it loads. The folder build/web/page can
# be served unchanged.
set(page ${CMAKE_BINARY_DIR}/page)
set_target_properties(coaster PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${page})
# CLI11 throws; nothing else does.
set_source_files_properties(src/app/options.cpp TARGET_DIRECTORY coaster_app
  PROPERTIES COMPILE_OPTIONS -fexceptions SKIP_UNITY_BUILD_INCLUSION ON)
target_link_options(coaster PRIVATE
  -fexceptions -sENVIRONMENT=web,worker -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sALLOW_MEMORY_GROWTH=1
  -sTOTAL_STACK=4MB -sEXIT_RUNTIME=1
  -sFORCE_FILESYSTEM=1 -lidbfs.js -sEXPORTED_RUNTIME_METHODS=FS,IDBFS,ENV,ccall,addRunDependency,removeRunDependency)
foreach(data tracks envelopes challenges tutorials)
  target_link_options(coaster PRIVATE "SHELL:--preload-file ${CMAKE_SOURCE_DIR}/${data}@/usr/share/coaster/${data}")
endforeach()
# The largest samples would make the page a twentieth larger.
foreach(large kestrel night_heron copper_gulch fox_and_thicket)
  target_link_options(coaster PRIVATE "SHELL:--exclude-file *park_${large}.json")
endforeach()
target_link_options(coaster PRIVATE "SHELL:--exclude-file *.lock")  # of tracks that are open while this is built
# The files around the program. The worker's version is a hash of the files that it caches.
add_custom_command(TARGET coaster POST_BUILD
  COMMAND ${CMAKE_COMMAND} -Dfrom=${CMAKE_SOURCE_DIR}/packaging/web -Dto=${page}
          -P ${CMAKE_CURRENT_LIST_DIR}/web_files.cmake VERBATIM)
file(GLOB page_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/packaging/web/*.html ${CMAKE_SOURCE_DIR}/packaging/web/*.js)
set_property(TARGET coaster APPEND PROPERTY LINK_DEPENDS ${page_files})
