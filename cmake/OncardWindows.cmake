# The builds for Windows, with Debian's mingw-w64. They cannot run what they build: the generator of
# headers and entry points is that of a build for this computer, which ./x windows makes first.
set(ONCARD_GENERATE_INTERFACE "" CACHE FILEPATH "generate_interface of a build for this computer")
if(NOT EXISTS "${ONCARD_GENERATE_INTERFACE}")
  message(FATAL_ERROR "ONCARD_GENERATE_INTERFACE names no program: use ./x windows, or build the target "
    "generate_interface in build/release and name build/release/gtcalls/generate_interface")
endif()
include(OncardHeaderOnly)

# Where a source takes care of a system, the one for Windows ends so.
set(ONCARD_SYSTEM _windows)
set(ONCARD_HANDLER_CALL __stdcall)

# The interface of Windows 7, without the parts that define short words as macros. printf() is that
# of C, not that of the old library of Windows. Unity builds have more sections than the plain format
# of objects can number. Sizes of files have 64 bits.
target_compile_definitions(oncard_options INTERFACE
  _WIN32_WINNT=0x0601 _FILE_OFFSET_BITS=64 NOMINMAX WIN32_LEAN_AND_MEAN __USE_MINGW_ANSI_STDIO=1)
target_compile_options(oncard_options INTERFACE -Wa,-mbig-obj)
if(CMAKE_SIZEOF_VOID_P EQUAL 4)
  # As in OncardHost32: the results of 64 bits. Threads of a host may have a stack that is aligned to
  # four bytes only.
  target_compile_options(oncard_options INTERFACE -msse2 -mfpmath=sse -mstackrealign)
endif()

# For the import libraries of Visual C++.
find_program(ONCARD_LLVM_DLLTOOL NAMES llvm-dlltool-19 llvm-dlltool REQUIRED)

# oncard_windows_library(name family generator part interrupts): <family>.dll, for which oncard_family() has
# made the rest. It exports what the generator lists, and nothing else. `part` is empty, or multi- for a
# library whose plain names have a card number; that one is in the folder multi. `interrupts`: its cards
# interrupt their host. Beside each library are its import libraries: <family>.lib for Visual C++,
# lib<family>.a for mingw. In 32 bits names are exported without decoration, and the import libraries know it.
function(oncard_windows_library name family generator part interrupts)
  set(host_dir ${PROJECT_SOURCE_DIR}/runtime/host)
  if(CMAKE_SIZEOF_VOID_P EQUAL 4)
    set(exports ${part}exports-x86)
    set(machine i386)
  else()
    set(exports ${part}exports-x64)
    set(machine i386:x86-64)
  endif()
  set(definition ${CMAKE_CURRENT_BINARY_DIR}/${name}.def)
  oncard_interface_file(${family} ${generator} ${exports} ${definition})
  add_library(${name} SHARED ${host_dir}/host_hooks.cc ${host_dir}/host_life_windows.cc ${definition})
  add_library(oncard::${name} ALIAS ${name})
  set(folder ${PROJECT_BINARY_DIR}/bin)
  if(part)
    set(folder ${PROJECT_BINARY_DIR}/multi)
  endif()
  # The linker's import library, which does not know decorated names, makes way for that of dlltool.
  set_target_properties(${name} PROPERTIES PREFIX "" IMPORT_PREFIX lib IMPORT_SUFFIX .a
    OUTPUT_NAME ${family} UNITY_BUILD OFF
    ARCHIVE_OUTPUT_DIRECTORY ${folder} RUNTIME_OUTPUT_DIRECTORY ${folder})
  target_compile_definitions(${name} PRIVATE ONCARD_INTERRUPTS=$<BOOL:${interrupts}>)
  target_link_options(${name} PRIVATE -s LINKER:--kill-at)  # without its symbols
  target_link_libraries(${name}
    PRIVATE oncard_options oncard_${family}_entry_points
    INTERFACE oncard::${family}_interface)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${ONCARD_LLVM_DLLTOOL} -m ${machine} -k -d ${definition} -l ${folder}/${family}.lib
    COMMAND ${CMAKE_DLLTOOL} -k -d ${definition} -l ${folder}/lib${family}.a
    VERBATIM)
endfunction()
