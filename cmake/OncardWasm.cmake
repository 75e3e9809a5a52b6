# The build for WebAssembly (preset `wasm`): everything that computes, without threads, files, the
# host library and the command. There are no exceptions: an error that would throw one ends the
# module.
include(OncardHeaderOnly)

# Where a source takes care of a system, the one for WebAssembly ends so.
set(ONCARD_SYSTEM _wasi)

target_compile_definitions(nlohmann_json::nlohmann_json INTERFACE JSON_NOEXCEPTION)

target_compile_options(oncard_options INTERFACE -fno-exceptions)
find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp PATHS /usr/include NO_DEFAULT_PATH REQUIRED)
