# The libraries for the 32-bit build of libgts on a 64-bit computer, with Debian's g++-multilib.
# Debian has the libraries only for 64 bits. They are used as header-only libraries, which do not
# depend on the word length, and are found without their CMake files, which would reject the other
# word length.
if(NOT CMAKE_SIZEOF_VOID_P EQUAL 4)
  message(FATAL_ERROR "ONCARD_HOST32 needs a 32-bit compiler: cmake --preset host32")
endif()

add_library(FastFloat::fast_float INTERFACE IMPORTED)
add_library(fmt::fmt INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
add_library(PkgConfig::XXHASH INTERFACE IMPORTED)
target_compile_definitions(PkgConfig::XXHASH INTERFACE XXH_INLINE_ALL)

# Doubles in 64-bit registers, not in the 80-bit registers of the x87 coprocessor: the same results as
# elsewhere. 64-bit file offsets, or files with large inode numbers could not be opened.
target_compile_options(oncard_options INTERFACE -msse2 -mfpmath=sse)
target_compile_definitions(oncard_options INTERFACE _FILE_OFFSET_BITS=64)
