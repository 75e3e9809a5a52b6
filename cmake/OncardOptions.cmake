# Compiler options of all targets: warnings are errors, results must not depend on floating-point
# contraction, and the shared library exports only the C API. -O2 is as fast as CMake's -O3 in ./x
# bench vm and compiles faster. Sanitizers need it, too: with -O1 clang inlines nothing, compiles
# hardly faster, and tests of cards take twice as long.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
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
