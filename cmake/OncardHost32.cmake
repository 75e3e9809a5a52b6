# The libraries for the build of libgts for hosts of 32 bits, on a computer of 64: Debian's packages
# g++-multilib and lib32z1-dev. The others it has for 64 bits alone. They are used as headers, which
# have no word length, found without their CMake files, which refuse another one than their own.
if(NOT CMAKE_SIZEOF_VOID_P EQUAL 4)
  message(FATAL_ERROR "ONCARD_HOST32 needs a compiler of 32 bits: cmake --preset host32")
endif()

pkg_check_modules(EIGEN REQUIRED eigen3)
add_library(Eigen3::Eigen INTERFACE IMPORTED)
target_include_directories(Eigen3::Eigen SYSTEM INTERFACE ${EIGEN_INCLUDE_DIRS})
add_library(fmt::fmt INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
add_library(PkgConfig::XXHASH INTERFACE IMPORTED)
target_compile_definitions(PkgConfig::XXHASH INTERFACE XXH_INLINE_ALL)
add_library(ZLIB::ZLIB INTERFACE IMPORTED)
target_link_libraries(ZLIB::ZLIB INTERFACE z)

# Doubles in registers of 64 bits, not the 80 of the old coprocessor: the same results as elsewhere.
# Files have 64 bits, or those whose numbers need more than 32 could not be opened.
target_compile_options(oncard_options INTERFACE -msse2 -mfpmath=sse)
target_compile_definitions(oncard_options INTERFACE _FILE_OFFSET_BITS=64)
