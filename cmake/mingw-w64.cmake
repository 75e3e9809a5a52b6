# Toolchain for Windows: Debian's packages g++-mingw-w64-x86-64-posix and g++-mingw-w64-i686-posix. The
# presets `windows-x64` and `windows-x86` use it; ONCARD_MINGW is the first word of the compilers' names.
# Everything is linked statically: what is built needs nothing that Windows does not have.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR ${ONCARD_MINGW})
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ONCARD_MINGW)
set(CMAKE_C_COMPILER ${ONCARD_MINGW}-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER ${ONCARD_MINGW}-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER ${ONCARD_MINGW}-w64-mingw32-windres)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)
