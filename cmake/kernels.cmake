# Options of the vector kernels (src/curve/kernels_*.cpp): optimised in every build type, so that tests and debug builds
# stay fast, and on x86-64 a second copy with AVX2 and FMA, chosen at run time. The rest of the program uses the
# baseline's instructions. Vertices are only displayed, so their kernels may use fused multiply-add.
set(kernel_options $<IF:$<BOOL:${COASTER_SANITIZE}>,-O1,-O3>)  # with sanitizers -O3 takes minutes to compile
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND kernel_options -ftree-slp-vectorize)  # only displayed values, or no roundings to float and back
endif()
# kernel(SOURCE [option ...])
function(kernel source)
  set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${kernel_options};${ARGN}"
                                                   SKIP_PRECOMPILE_HEADERS ON)
endfunction()
kernel(src/curve/kernels_baseline.cpp)
kernel(src/sim/ride/lap_table.cpp)     # its loops process several trains at once
kernel(src/view/pick_cone.cpp)         # products of short polynomials
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$" AND NOT EMSCRIPTEN)
  kernel(src/curve/kernels_avx2.cpp -mavx2 -mfma -ffp-contract=fast)
  set_source_files_properties(src/curve/kernels.cpp src/curve/kernels_avx2.cpp
                              PROPERTIES COMPILE_DEFINITIONS COASTER_AVX2_KERNELS)
endif()
