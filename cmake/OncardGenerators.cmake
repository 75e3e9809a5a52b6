# Source generators. Their output is only in the build tree. The target oncard_generated generates
# all of it and nothing else, for clang-tidy.
add_custom_target(oncard_generated)

function(oncard_generated_sources target name)
  add_custom_target(${target}_${name}_sources DEPENDS ${ARGN})
  add_dependencies(${target} ${target}_${name}_sources)
  add_dependencies(oncard_generated ${target}_${name}_sources)
endfunction()

# oncard_output(output source): the place of the file generated from a source: at the same path in
# the build tree.
function(oncard_output output source)
  get_filename_component(name ${source} NAME_WE)
  get_filename_component(folder ${CMAKE_CURRENT_BINARY_DIR}/${source} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  set(${output} ${folder}/${name} PARENT_SCOPE)
endfunction()

# oncard_re2c(target lexer.re): adds the scanner generated from `lexer.re` to the target.
function(oncard_re2c target source)
  find_program(RE2C_EXECUTABLE re2c REQUIRED)
  get_filename_component(name ${source} NAME_WE)
  oncard_output(output ${source})
  set(output ${output}.cc)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${RE2C_EXECUTABLE} -W -Werror --input-encoding utf8 -i -o ${output}
            ${CMAKE_CURRENT_SOURCE_DIR}/${source}
    DEPENDS ${source}
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  oncard_generated_sources(${target} ${name} ${output})
endfunction()

# oncard_bison(target parser.yy): adds the parser generated from `parser.yy` and its header,
# parser.hh, whose name prevents clang-tidy from treating it as a header of the project.
function(oncard_bison target source)
  find_package(BISON 3.8 REQUIRED)
  get_filename_component(name ${source} NAME_WE)
  oncard_output(output ${source})
  set(header ${output}.hh)
  set(output ${output}.cc)
  add_custom_command(
    OUTPUT ${output} ${header}
    COMMAND ${BISON_EXECUTABLE} -Wall -Werror --header=${header} -o ${output}
            ${CMAKE_CURRENT_SOURCE_DIR}/${source}
    DEPENDS ${source}
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  oncard_generated_sources(${target} ${name} ${output})
  # The code of Bison's skeleton narrows the entries of its tables, and counts errors.
  set_source_files_properties(${output} PROPERTIES COMPILE_OPTIONS
    "-Wno-conversion;-Wno-unused-but-set-variable")
endfunction()

# oncard_texts(target name.inc file ...): name.inc, which sources of the target can include, has a row
# for each file: {"its name", R"text(its bytes)text"},
function(oncard_texts target name)
  set(files ${ARGN})
  list(TRANSFORM files PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${name})
  set(script ${PROJECT_SOURCE_DIR}/cmake/texts.cmake)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D OUTPUT=${output} -D "TEXTS=${files}" -P ${script}
    DEPENDS ${files} ${script}
    VERBATIM)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
  get_filename_component(stem ${name} NAME_WE)
  oncard_generated_sources(${target} ${stem} ${output})
endfunction()
