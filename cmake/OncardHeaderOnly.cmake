# The libraries as header-only libraries, for builds for something else than the computer itself:
# Debian has them compiled only for that. Their CMake files would refuse the other word length.
find_path(EIGEN3_INCLUDE_DIR Eigen/Core PATHS /usr/include PATH_SUFFIXES eigen3 NO_DEFAULT_PATH REQUIRED)
add_library(Eigen3::Eigen INTERFACE IMPORTED)
target_include_directories(Eigen3::Eigen INTERFACE ${EIGEN3_INCLUDE_DIR})
add_library(CLI11::CLI11 INTERFACE IMPORTED)
add_library(FastFloat::fast_float INTERFACE IMPORTED)
add_library(fmt::fmt INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
add_library(PkgConfig::XXHASH INTERFACE IMPORTED)
target_compile_definitions(PkgConfig::XXHASH INTERFACE XXH_INLINE_ALL)

# A compiler for another system has no headers of this one. What it may share with it are the headers
# of these libraries: it finds them in a folder of links.
if(ONCARD_WINDOWS)
  set(folder ${PROJECT_BINARY_DIR}/libraries)
  file(MAKE_DIRECTORY ${folder})
  foreach(header IN ITEMS CLI/CLI.hpp fast_float/fast_float.h fmt/core.h nlohmann/json.hpp
      rapidxml/rapidxml.hpp toml++/toml.h xxhash.h)
    string(MAKE_C_IDENTIFIER ${header} name)
    find_path(ONCARD_${name} ${header} PATHS /usr/include NO_DEFAULT_PATH REQUIRED)
    string(REGEX REPLACE "/.*" "" entry ${header})
    file(CREATE_LINK ${ONCARD_${name}}/${entry} ${folder}/${entry} SYMBOLIC)
  endforeach()
  include_directories(SYSTEM ${folder})
endif()
