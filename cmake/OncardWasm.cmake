# The build for WebAssembly (preset `wasm`): everything that computes, without threads, files, the
# host library and the command. There are no exceptions: an error that would throw one ends the
# module.
include(OncardHeaderOnly)

# Where a source takes care of a system, the one for WebAssembly ends so.
set(ONCARD_SYSTEM _wasi)

target_compile_definitions(nlohmann_json::nlohmann_json INTERFACE JSON_NOEXCEPTION)

# Modules are downloaded: optimized as a whole they are smaller by 2 %. A target with ONCARD_THROWS can throw.
target_compile_options(oncard_options INTERFACE
  $<IF:$<BOOL:$<TARGET_PROPERTY:ONCARD_THROWS>>,-fexceptions,-fno-exceptions> -flto)
target_link_options(oncard_options INTERFACE -flto)
find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp PATHS /usr/include NO_DEFAULT_PATH REQUIRED)

# oncard_small_sources(TARGET SOURCES ...): sources of a library that are compiled to be small. They become objects
# of their own target: with an option of its own, each would be compiled alone.
function(oncard_small_sources target)
  foreach(property SOURCES SOURCE_DIR LINK_LIBRARIES)
    get_target_property(${property} ${target} ${property})
  endforeach()
  list(REMOVE_ITEM SOURCES ${ARGN})
  set_target_properties(${target} PROPERTIES SOURCES "${SOURCES}")
  list(TRANSFORM ARGN PREPEND ${SOURCE_DIR}/)
  add_library(${target}_small OBJECT ${ARGN})
  target_link_libraries(${target}_small PRIVATE ${LINK_LIBRARIES})
  target_compile_definitions(${target}_small PRIVATE $<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>)
  target_compile_options(${target}_small PRIVATE -Oz)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_small>)
endfunction()

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
