# Compiler options of all targets.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# -O3 gains nothing outside the kernels, which set it themselves (cmake/kernels.cmake), and takes a third longer to
# compile.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")

# The same numbers from every compiler and optimisation level: no fused multiply-add unless the source asks for it. sqrt
# need not set errno, which nothing reads.
add_compile_options(-ffp-contract=off -fno-math-errno -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers
                    -Werror=switch)  # a switch over kinds without a default is a table: no kind may be forgotten
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-fpch-preprocess)  # lets ccache see through precompiled headers
  # gcc 12 omits the rounding in double(float(x)) where it vectorises straight-line code (seen at -O2, not at -O0, nor
  # with clang): documents would differ between builds.
  add_compile_options(-fno-tree-slp-vectorize)
  # False positives about moved variants (gcc bug 105562) and about std::string + (gcc bugs 105329, 105651).
  add_compile_options(-Wno-maybe-uninitialized -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow)
endif()
if(EMSCRIPTEN)
  add_compile_options(-include ${CMAKE_SOURCE_DIR}/third_party/web/std_missing.h)
  add_compile_options(-Wno-dollar-in-identifier-extension)  # arguments of EM_ASM
endif()
add_compile_definitions(GLM_FORCE_XYZW_ONLY)
# Unoptimised code would call functions for every component of a vector. Inlined, it runs in 3/5 of the time and
# compiles as fast.
add_compile_definitions($<$<CONFIG:Debug>:GLM_FORCE_INLINE>)

if(COASTER_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  # Loaded at a fixed address, a program needs no million relocations of the sanitizers' tables at each start.
  add_compile_options(-fno-pie)
  add_link_options(-no-pie)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)  # indices of vectors, spans and texts are checked, too
endif()

include(${CMAKE_CURRENT_LIST_DIR}/kernels.cmake)  # per-file options of the vector kernels
