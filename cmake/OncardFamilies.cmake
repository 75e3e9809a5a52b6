# oncard_family(name EXPORTS pattern ... SOURCES file ...
#               [HEADER file ...] [MODULE_HEADER file] [OTHER_HEADERS file ...]
#               [MULTI_CARD] [BASIC_LAYOUTS] [INTERRUPTS] [CSHARP name]
#               [GENERATOR target] [INCLUDE_DIR folder] [LONG32_OF family]):
# all that a family of cards needs beside its catalogue and functions. Makes the targets
#
#   oncard::<name>_interface     the folder with its headers
#   oncard::<name>_entry_points  the functions of its library, for whoever is no library
#   oncard::<name>               lib<name>.so, with which host programs are linked; a link to the
#                                library itself, whose name ends in the version of its interface.
#                                <name>.dll for Windows
#
# EXPORTS are the names of its functions. SOURCES define its HostLibrary (runtime/host/library.h).
# HEADER is <name>.h unless it is given; several are spellings of one name. MODULE_HEADER, MULTI_CARD
# and BASIC_LAYOUTS are the parts that its InterfaceForm (gtcalls/interface_form.h) may have;
# OTHER_HEADERS are copied. INTERRUPTS: its cards interrupt their host, for which the library has
# events and handlers. CSHARP: declarations for C# in <name>.cs, those with a card number in
# <name>Multi.cs. GENERATOR knows the family, INCLUDE_DIR receives the headers; without them
# both are those of the project. LONG32_OF makes another library of a family, for declarations that
# were written for Windows: a `long` has 32 bits in it.
#
# The global property ONCARD_HOST_LIBRARIES lists the libraries that have been made.

# The version of the interface of all host libraries. It changes when hosts that were linked before
# would no longer run: when a function is taken away, or its parameters change (tests/abi). One number
# for all, because they are released together, in one package.
set(ONCARD_SOVERSION 1)

function(oncard_family name)
  cmake_parse_arguments(ARG "MULTI_CARD;BASIC_LAYOUTS;INTERRUPTS"
    "CSHARP;GENERATOR;INCLUDE_DIR;LONG32_OF;MODULE_HEADER" "EXPORTS;HEADER;OTHER_HEADERS;SOURCES" ${ARGN})
  if(NOT ARG_GENERATOR)
    set(ARG_GENERATOR generate_interface)
  endif()
  if(NOT ARG_HEADER)
    set(ARG_HEADER ${name}.h)
  endif()
  if(NOT ARG_INCLUDE_DIR)
    set(ARG_INCLUDE_DIR ${PROJECT_BINARY_DIR}/include)
  endif()
  set(family ${name})
  set(form)
  if(ARG_LONG32_OF)
    set(family ${ARG_LONG32_OF})
    set(form long32-)
  endif()
  set_property(GLOBAL APPEND PROPERTY ONCARD_HOST_LIBRARIES ${name})

  set(headers)
  foreach(header IN LISTS ARG_HEADER)
    list(APPEND headers ${ARG_INCLUDE_DIR}/${header})
    oncard_interface_file(${family} ${ARG_GENERATOR} ${form}header ${ARG_INCLUDE_DIR}/${header})
  endforeach()
  set(parts entry-points structures)
  if(ARG_MODULE_HEADER)
    list(APPEND headers ${ARG_INCLUDE_DIR}/${ARG_MODULE_HEADER})
    oncard_interface_file(${family} ${ARG_GENERATOR} ${form}module-header
      ${ARG_INCLUDE_DIR}/${ARG_MODULE_HEADER})
  endif()
  if(ARG_CSHARP)
    list(APPEND headers ${ARG_INCLUDE_DIR}/${ARG_CSHARP}.cs)
    oncard_interface_file(${family} ${ARG_GENERATOR} csharp ${ARG_INCLUDE_DIR}/${ARG_CSHARP}.cs)
    if(ARG_MULTI_CARD)
      list(APPEND headers ${ARG_INCLUDE_DIR}/${ARG_CSHARP}Multi.cs)
      oncard_interface_file(${family} ${ARG_GENERATOR} multi-csharp
        ${ARG_INCLUDE_DIR}/${ARG_CSHARP}Multi.cs)
    endif()
  endif()
  set(generated ${headers})
  foreach(header IN LISTS ARG_OTHER_HEADERS)
    get_filename_component(file ${header} NAME)
    configure_file(${header} ${ARG_INCLUDE_DIR}/${file} COPYONLY)
    list(APPEND headers ${ARG_INCLUDE_DIR}/${file})
  endforeach()
  if(ARG_MULTI_CARD)
    list(APPEND parts multi-entry-points)
  endif()
  if(ARG_BASIC_LAYOUTS)
    list(APPEND parts basic-entry-points)
    if(ONCARD_WINDOWS AND ARG_MULTI_CARD)
      list(APPEND parts multi-basic-entry-points)
    endif()
  endif()
  set(sources)
  foreach(part IN LISTS parts)
    string(REPLACE - _ file ${part})
    list(APPEND sources ${CMAKE_CURRENT_BINARY_DIR}/${name}_${file}.cc)
    oncard_interface_file(${family} ${ARG_GENERATOR} ${form}${part}
      ${CMAKE_CURRENT_BINARY_DIR}/${name}_${file}.cc)
  endforeach()

  add_custom_target(oncard_${name}_interface_files DEPENDS ${generated} ${sources})
  add_dependencies(oncard_generated oncard_${name}_interface_files)
  add_library(oncard_${name}_interface INTERFACE)
  add_library(oncard::${name}_interface ALIAS oncard_${name}_interface)
  target_include_directories(oncard_${name}_interface INTERFACE ${ARG_INCLUDE_DIR})
  add_dependencies(oncard_${name}_interface oncard_${name}_interface_files)

  # Functions of one card and of several have the same names in their sources.
  add_library(oncard_${name}_entry_points OBJECT ${sources} ${ARG_SOURCES})
  add_library(oncard::${name}_entry_points ALIAS oncard_${name}_entry_points)
  set_target_properties(oncard_${name}_entry_points PROPERTIES UNITY_BUILD OFF)
  target_link_libraries(oncard_${name}_entry_points
    PUBLIC oncard::${name}_interface oncard::host_api PRIVATE oncard::compiler)

  if(ONCARD_WINDOWS)
    oncard_windows_library(${name} ${family} ${ARG_GENERATOR} "" ${ARG_INTERRUPTS})
    if(ARG_MULTI_CARD)
      oncard_windows_library(${name}_multi ${family} ${ARG_GENERATOR} multi- ${ARG_INTERRUPTS})
    endif()
    return()
  endif()
  add_library(${name} SHARED
    ${PROJECT_SOURCE_DIR}/runtime/host/host_hooks.cc ${PROJECT_SOURCE_DIR}/runtime/host/host_life.cc)
  if(ARG_INTERRUPTS)
    target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/runtime/host/interrupt_hooks.cc)
  endif()
  # ThreadSanitizer has a sigaction() of its own, and calls it before instrumented code may run.
  if(NOT ONCARD_SANITIZE MATCHES thread)
    target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/runtime/host/host_handlers.cc)
  endif()
  # The same sources are in each library: clang-tidy looks at those of the first one, and where there are more.
  get_property(libraries GLOBAL PROPERTY ONCARD_HOST_LIBRARIES)
  list(FIND libraries ${name} earlier)
  if(ONCARD_LINT AND earlier GREATER 0 AND NOT ARG_INTERRUPTS)
    set_target_properties(${name} PROPERTIES EXPORT_COMPILE_COMMANDS OFF)
  endif()
  add_library(oncard::${name} ALIAS ${name})
  list(JOIN ARG_EXPORTS ";\n    " exports)
  set(map ${CMAKE_CURRENT_BINARY_DIR}/${name}.map)
  configure_file(${PROJECT_SOURCE_DIR}/runtime/host/family.map.in ${map} @ONLY)
  set_target_properties(${name} PROPERTIES
    LINK_DEPENDS ${map} SOVERSION ${ONCARD_SOVERSION} UNITY_BUILD OFF)
  if(NOT ARG_LONG32_OF)  # whose headers are not for hosts
    set_target_properties(${name} PROPERTIES PUBLIC_HEADER "${headers}")
  endif()
  target_link_options(${name} PRIVATE LINKER:--version-script=${map})
  if(NOT ONCARD_SANITIZE)  # a sanitizer's run-time library comes with the program
    target_link_options(${name} PRIVATE LINKER:--no-undefined)
  endif()
  target_link_libraries(${name}
    PRIVATE oncard_options oncard_${name}_entry_points
    INTERFACE $<BUILD_INTERFACE:oncard_${name}_interface>)
endfunction()

# oncard_family_of_host(result source): the family with whose library a host is linked: that of its header.
function(oncard_family_of_host result source)
  file(STRINGS ${source} header REGEX "#include \"(ge[ps]|GT400|userlib).h\"")
  if(header MATCHES "\"(ge[ps]).h\"")
    set(family ${CMAKE_MATCH_1})
  elseif(header)
    set(family gt400)
  else()
    set(family gts)
  endif()
  set(${result} ${family} PARENT_SCOPE)
endfunction()

# oncard_interface_file(family generator what output): a file that a generator writes.
function(oncard_interface_file family generator what output)
  get_filename_component(folder ${output} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  add_custom_command(OUTPUT ${output} COMMAND ${generator} ${family} ${what} ${output}
    DEPENDS ${generator} VERBATIM)
endfunction()
