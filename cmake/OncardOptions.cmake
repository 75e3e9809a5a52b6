# Compiler options of all targets: warnings are errors, results must not depend on floating-point
# contraction, and the shared library exports only the C API. -O2 is as fast as CMake's -O3 in ./x
# bench vm and compiles faster. Sanitizers need it, too: with -O1 clang inlines nothing, compiles
# hardly faster, and tests of cards take twice as long.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
# Sources that were compiled before are not compiled again where ccache works, most of them not even
# in another clone. It fails where it cannot write, as in a home that is read-only. It is told that
# the times of included files and of precompiled headers mean nothing: their contents decide.
find_program(ONCARD_CCACHE ccache)
if(ONCARD_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  execute_process(
    COMMAND ${ONCARD_CCACHE} ${CMAKE_CXX_COMPILER} -c -x c++ /dev/null
      -o ${PROJECT_BINARY_DIR}/ccache_works.o
    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(NOT failed)
    set(sloppiness pch_defines,time_macros,include_file_mtime,include_file_ctime)
    foreach(language C CXX)
      set(CMAKE_${language}_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
        CCACHE_SLOPPINESS=${sloppiness} ${ONCARD_CCACHE})
    endforeach()
  endif()
endif()
# Where a preset compiles several sources as one, it spends most of its time on headers and templates
# that they share.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 24)
add_library(oncard_options INTERFACE)
target_include_directories(oncard_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
target_compile_options(oncard_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Werror -ffp-contract=off -fvisibility=hidden)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ looks less often for memory to free: a tenth faster, with a tenth more memory.
  target_compile_options(oncard_options INTERFACE
    "SHELL:--param ggc-min-expand=200" "SHELL:--param ggc-min-heapsize=262144")
endif()
if(ONCARD_FUZZ)
  # What -fsanitize=fuzzer-no-link has beyond this are calls at every comparison: the tests of this
  # build took up to four times as long with them. Words that they would find are in the
  # dictionaries of tests/fuzz.
  target_compile_options(oncard_options INTERFACE -fsanitize-coverage=inline-8bit-counters,pc-table)
endif()
if(ONCARD_SANITIZE)
  target_compile_options(oncard_options INTERFACE
    -fsanitize=${ONCARD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(oncard_options INTERFACE -fsanitize=${ONCARD_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ 12 sees uninitialised members in std::variant where its own instrumentation hides them.
    target_compile_options(oncard_options INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()
# oncard_system_sources(result name ...): what each system does in its own way. Of a name's sources, name.cc
# and those such as name_windows.cc and name_wasi.cc, a build takes the one that ends in ONCARD_SYSTEM, or
# name.cc if there is none.
function(oncard_system_sources result)
  set(sources)
  foreach(name IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH name BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE path)
    if(EXISTS ${path}${ONCARD_SYSTEM}.cc)
      list(APPEND sources ${path}${ONCARD_SYSTEM}.cc)
    else()
      list(APPEND sources ${path}.cc)
    endif()
  endforeach()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()
