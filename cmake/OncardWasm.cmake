# The build for WebAssembly (preset `wasm`): everything that computes, without threads, files, the
# host library and the command. The libraries are used as header-only libraries, which the compiler
# finds where Debian has them for the computer itself. There are no exceptions: an error that would
# throw one ends the module.
add_library(FastFloat::fast_float INTERFACE IMPORTED)
add_library(fmt::fmt INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
target_compile_definitions(nlohmann_json::nlohmann_json INTERFACE JSON_NOEXCEPTION)
add_library(PkgConfig::XXHASH INTERFACE IMPORTED)
target_compile_definitions(PkgConfig::XXHASH INTERFACE XXH_INLINE_ALL)

target_compile_options(oncard_options INTERFACE -fno-exceptions)
