# The command in build/wasm/bin/oncard-cli.wasm, for web/cli. Libraries there are those of the modules for
# pages, which have no files and run no hosts: what the command needs beyond them is compiled with it.
set(others
  ${PROJECT_SOURCE_DIR}/base/file_writer.cc
  ${PROJECT_SOURCE_DIR}/base/files.cc
  ${PROJECT_SOURCE_DIR}/explore/host_exploration.cc
  ${PROJECT_SOURCE_DIR}/runtime/host/call_log.cc
  ${PROJECT_SOURCE_DIR}/runtime/host/eni_writer.cc)
oncard_system_sources(file_sources
  ${PROJECT_SOURCE_DIR}/base/descriptor
  ${PROJECT_SOURCE_DIR}/base/file_names
  ${PROJECT_SOURCE_DIR}/base/file_steps)
list(APPEND sources ${system_sources} ${others} ${file_sources} main.cc system_wasi.cc)
add_executable(oncard_cli_wasm ${sources})
oncard_texts(oncard_cli_wasm new_templates.inc ${new_templates})
# It can throw, but not catch: see system_wasi.cc.
set_target_properties(oncard_cli_wasm PROPERTIES OUTPUT_NAME oncard-cli SUFFIX .wasm ONCARD_THROWS ON)
target_compile_definitions(oncard_cli_wasm PRIVATE
  ${definitions} CLI11_HAS_FILESYSTEM=0 _WASI_EMULATED_SIGNAL)
target_compile_options(oncard_cli_wasm PRIVATE
  -Oz -include ${CMAKE_CURRENT_SOURCE_DIR}/file_streams_wasi.h)
target_include_directories(oncard_cli_wasm SYSTEM PRIVATE ${CLI11_INCLUDE_DIR})
target_link_libraries(oncard_cli_wasm PRIVATE
  oncard::explore oncard::session oncard::protocol_schema oncard::runtime oncard::compiler
  nlohmann_json::nlohmann_json PkgConfig::XXHASH
  wasi-emulated-signal c-printscan-long-double)
oncard_module_link(oncard_cli_wasm)
