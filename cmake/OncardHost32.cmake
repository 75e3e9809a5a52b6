# The 32-bit build of libgts on a 64-bit computer, with Debian's g++-multilib.
if(NOT CMAKE_SIZEOF_VOID_P EQUAL 4)
  message(FATAL_ERROR "ONCARD_HOST32 needs a 32-bit compiler: cmake --preset host32")
endif()
include(OncardHeaderOnly)

# Doubles in 64-bit registers, not in the 80-bit registers of the x87 coprocessor: the same results as
# elsewhere. 64-bit file offsets, or files with large inode numbers could not be opened.
target_compile_options(oncard_options INTERFACE -msse2 -mfpmath=sse)
target_compile_definitions(oncard_options INTERFACE _FILE_OFFSET_BITS=64)
