# coaster_embed(TARGET SYMBOL FILE): embeds the bytes of a file in the program. Adds to TARGET a generated source with
#   namespace coaster::embedded { extern const unsigned char SYMBOL[]; extern const std::size_t SYMBOL_size; }
# SYMBOL_size is the file's size in bytes; SYMBOL[SYMBOL_size] is a zero, so that text can be read as a C string. The
# user declares these two lines. The build runs this file as a script to generate the source, only when the input
# changes; a 600 KB font takes about a second.
if(CMAKE_SCRIPT_MODE_FILE)
  file(READ ${input} hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
  # Lines of 32 bytes, because compilers and editors are slow with one long line. CMake's regular expressions have no
  # repeat counts, so the pattern is written out.
  string(REPEAT "0x..," 32 line)
  string(REGEX REPLACE "(${line})" "\\1\n" bytes "${bytes}")
  file(WRITE ${output} "#include <cstddef>
namespace coaster::embedded {
extern const unsigned char ${symbol}[];
extern const std::size_t ${symbol}_size;
const unsigned char ${symbol}[] = {
${bytes}0};
const std::size_t ${symbol}_size = ${size};
}  // namespace coaster::embedded
")
  return()
endif()

set(COASTER_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
function(coaster_embed target symbol file)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/embedded/${symbol}.cpp)
  add_custom_command(
    OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -Dinput=${file} -Doutput=${generated} -Dsymbol=${symbol} -P ${COASTER_EMBED_SCRIPT}
    DEPENDS ${file} ${COASTER_EMBED_SCRIPT}
    COMMENT "Embedding ${file}" VERBATIM)
  target_sources(${target} PRIVATE ${generated})
endfunction()
