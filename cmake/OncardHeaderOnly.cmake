# The libraries as header-only libraries, for builds for something else than the computer itself:
# Debian has them compiled only for that. Their CMake files would refuse the other word length.
find_path(EIGEN3_INCLUDE_DIR Eigen/Core PATHS /usr/include PATH_SUFFIXES eigen3 NO_DEFAULT_PATH REQUIRED)
add_library(Eigen3::Eigen INTERFACE IMPORTED)
target_include_directories(Eigen3::Eigen INTERFACE ${EIGEN3_INCLUDE_DIR})
add_library(FastFloat::fast_float INTERFACE IMPORTED)
add_library(fmt::fmt INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
add_library(PkgConfig::XXHASH INTERFACE IMPORTED)
target_compile_definitions(PkgConfig::XXHASH INTERFACE XXH_INLINE_ALL)
