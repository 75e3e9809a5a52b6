# The command in build/wasm/bin/oncard-cli.wasm, for web/cli: the same sources, and those that stand in
# for what WebAssembly does not have.
set(sources
  ${PROJECT_SOURCE_DIR}/base/descriptor.cc
  ${PROJECT_SOURCE_DIR}/base/file_names_wasi.cc
  ${PROJECT_SOURCE_DIR}/base/file_steps_wasi.cc
  ${PROJECT_SOURCE_DIR}/base/file_writer.cc
  ${PROJECT_SOURCE_DIR}/base/files.cc
  ${PROJECT_SOURCE_DIR}/explore/host_exploration.cc
  ${PROJECT_SOURCE_DIR}/runtime/host/call_log.cc
  ${PROJECT_SOURCE_DIR}/runtime/host/eni_writer.cc
  absent_command.cc
  absent_commands_wasi.cc
  app.cc
  build_command.cc
  check_command.cc
  command_tree.cc
  compile_arguments.cc
  debug_command.cc
  doctor_command.cc
  dump_command.cc
  eni_command.cc
  explain_command.cc
  explore_command.cc
  explore_options.cc
  explore_search.cc
  explore_subject.cc
  file_patterns.cc
  filter_wasi.cc
  folder_steps_wasi.cc
  folders.cc
  gnuplot.cc
  gnuplot_remedy_wasi.cc
  host_tests_absent.cc
  invocation.cc
  isolation_wasi.cc
  lower_command.cc
  main.cc
  memory_use_wasi.cc
  new_command.cc
  new_templates.cc
  out_of_memory.cc
  output_width.cc
  packaging_commands.cc
  packed_outcome.cc
  picture_names.cc
  processor_count_wasi.cc
  program_warnings.cc
  project_session.cc
  replay_command.cc
  run_command.cc
  run_report.cc
  run_views.cc
  scenario_folder.cc
  schema_command.cc
  search_look.cc
  search_watch_wasi.cc
  stop_signal_numbers.cc
  stop_signals.cc
  system_wasi.cc
  terminal.cc
  terminal_width_wasi.cc
  test_command.cc
  test_report.cc
  unnamed_search.cc
  verify_command.cc)
add_executable(oncard_cli_wasm ${sources})
oncard_texts(oncard_cli_wasm new_templates.inc ${new_templates})
# They can throw, but not catch: see system_wasi.cc.
set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS -fexceptions)
set_target_properties(oncard_cli_wasm PROPERTIES OUTPUT_NAME oncard-cli SUFFIX .wasm UNITY_BUILD OFF)
target_compile_definitions(oncard_cli_wasm PRIVATE
  ONCARD_VERSION="${PROJECT_VERSION}"
  ONCARD_COMPILER="${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
  ONCARD_BUILD_TYPE="${CMAKE_BUILD_TYPE}"
  ONCARD_EIGEN_VERSION="" ONCARD_FAST_FLOAT_VERSION="" ONCARD_HTTPLIB_VERSION=""
  CLI11_HAS_FILESYSTEM=0 _WASI_EMULATED_SIGNAL)
target_compile_options(oncard_cli_wasm PRIVATE
  -Oz -include ${CMAKE_CURRENT_SOURCE_DIR}/file_streams_wasi.h)
target_include_directories(oncard_cli_wasm SYSTEM PRIVATE ${CLI11_INCLUDE_DIR})
target_link_libraries(oncard_cli_wasm PRIVATE
  oncard::explore oncard::session oncard::protocol_schema oncard::runtime oncard::compiler
  nlohmann_json::nlohmann_json PkgConfig::XXHASH
  wasi-emulated-signal c-printscan-long-double)
target_link_options(oncard_cli_wasm PRIVATE
  LINKER:--strip-all LINKER:--stack-first LINKER:-z,stack-size=4194304)
add_custom_command(TARGET oncard_cli_wasm POST_BUILD
  COMMAND ${WASM_OPT_EXECUTABLE} -Os --enable-tail-call --enable-sign-ext --enable-mutable-globals
          $<TARGET_FILE:oncard_cli_wasm> -o $<TARGET_FILE:oncard_cli_wasm>
  VERBATIM)
