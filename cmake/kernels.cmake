# Options of the vector kernels (src/curve/kernels_*.cpp): optimised in every build type, so that tests and debug builds
# stay fast, and on x86-64 a second copy with AVX2 and FMA, chosen at run time. The rest of the program uses the
# baseline's instructions. Vertices are only displayed, so their kernels may use fused multiply-add.
set(kernel_options $<IF:$<BOOL:${COASTER_SANITIZE}>,-O1,-O3>)  # with sanitizers -O3 takes minutes to compile
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND kernel_options -ftree-slp-vectorize)  # only displayed values, or no roundings to float and back
endif()
set_source_files_properties(src/curve/kernels_baseline.cpp PROPERTIES COMPILE_OPTIONS "${kernel_options}" SKIP_PRECOMPILE_HEADERS ON)
set_source_files_properties(src/sim/ride/lap_table.cpp PROPERTIES COMPILE_OPTIONS "${kernel_options}" SKIP_PRECOMPILE_HEADERS ON)  # its loops process several trains at once
set_source_files_properties(src/view/sighted_curve.cpp PROPERTIES COMPILE_OPTIONS "${kernel_options}" SKIP_PRECOMPILE_HEADERS ON)  # products of short polynomials
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$" AND NOT EMSCRIPTEN)
  set_source_files_properties(src/curve/kernels_avx2.cpp PROPERTIES
    COMPILE_OPTIONS "${kernel_options};-mavx2;-mfma;-ffp-contract=fast" COMPILE_DEFINITIONS COASTER_AVX2_KERNELS SKIP_PRECOMPILE_HEADERS ON)
  set_source_files_properties(src/curve/kernels.cpp PROPERTIES COMPILE_DEFINITIONS COASTER_AVX2_KERNELS)
endif()
