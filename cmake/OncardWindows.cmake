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

# oncard_windows_library(name): <name>.dll of a family, for which oncard_family() has made the rest.
function(oncard_windows_library name)
  set(host_dir ${PROJECT_SOURCE_DIR}/runtime/host)
  add_library(${name} SHARED ${host_dir}/host_hooks.cc ${host_dir}/host_life_windows.cc)
  add_library(oncard::${name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES PREFIX "" UNITY_BUILD OFF)
  # Neither its symbols, nor what static libraries in it would export.
  target_link_options(${name} PRIVATE -s LINKER:--exclude-libs,ALL)
  target_link_libraries(${name}
    PRIVATE oncard_options oncard_${name}_entry_points
    INTERFACE oncard::${name}_interface)
endfunction()
