# The libraries as header-only libraries, for builds for something else than the computer itself:
# Debian has them compiled only for that. Their CMake files would refuse the other word length.
add_library(FastFloat::fast_float INTERFACE IMPORTED)
add_library(fmt::fmt INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
add_library(PkgConfig::XXHASH INTERFACE IMPORTED)
target_compile_definitions(PkgConfig::XXHASH INTERFACE XXH_INLINE_ALL)
