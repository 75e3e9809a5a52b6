# The build for WebAssembly (preset `wasm`): everything that computes, without threads, files, the
# host library and the command. There are no exceptions: an error that would throw one ends the
# module.
include(OncardHeaderOnly)

# Where a source takes care of a system, the one for WebAssembly ends so.
set(ONCARD_SYSTEM _wasi)

target_compile_definitions(nlohmann_json::nlohmann_json INTERFACE JSON_NOEXCEPTION)

# Modules are downloaded: optimized as a whole they are smaller by 2 %.
target_compile_options(oncard_options INTERFACE -fno-exceptions -flto)
target_link_options(oncard_options INTERFACE -flto)
find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp PATHS /usr/include NO_DEFAULT_PATH REQUIRED)

# oncard_module_link(TARGET [OPTIONS ...]): links a module, with options for the linker. The stack comes first in
# memory, so that one that is too deep ends the module instead of overwriting its data.
find_program(WASM_OPT_EXECUTABLE wasm-opt REQUIRED)
function(oncard_module_link target)
  target_link_options(${target} PRIVATE
    ${ARGN} LINKER:--strip-all LINKER:--stack-first LINKER:-z,stack-size=4194304)
  # What the linker leaves is made smaller by another 5 %.
  add_custom_command(TARGET ${target} POST_BUILD
    COMMAND ${WASM_OPT_EXECUTABLE} -Oz --enable-tail-call --enable-sign-ext
            --enable-mutable-globals $<TARGET_FILE:${target}> -o $<TARGET_FILE:${target}>
    VERBATIM)
endfunction()
