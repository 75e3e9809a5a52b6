# Debian packages, which cpack makes of the components (cmake/OncardInstall.cmake). ./x package calls it.
#
# Everything but the sources comes from the time of the commit, which ./x gives in SOURCE_DATE_EPOCH:
# the version, so that a later commit replaces an earlier one, and the times in the packages.
string(TIMESTAMP commit_time "%Y%m%d%H%M%S" UTC)
string(TIMESTAMP changelog_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION}~git${commit_time})
set(CPACK_PACKAGE_CONTACT "oncard authors <oncard@oncard.invalid>")

# Licence and changelog, which every package has.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
string(REGEX REPLACE "^[^\n]*\n\n[^\n]*\n\n" "" licence "${licence}")  # title and owner
string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REGEX REPLACE "\n(.)" "\n \\1" licence " ${licence}")
configure_file(copyright.in ${CMAKE_CURRENT_BINARY_DIR}/copyright @ONLY)
configure_file(changelog.in ${CMAKE_CURRENT_BINARY_DIR}/changelog @ONLY)
execute_process(COMMAND gzip -9nf changelog
  WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} COMMAND_ERROR_IS_FATAL ANY)

# oncard_package(name SECTION section SUMMARY line DESCRIPTION text [DEPENDS ...] [RECOMMENDS ...]
#                [SUGGESTS ...] [ALL]): the package of the component with this name. DEPENDS are added
# to the libraries that its programs need. ALL: for every processor.
macro(oncard_package name)
  cmake_parse_arguments(ARG "ALL" "SECTION;SUMMARY;DESCRIPTION;DEPENDS;RECOMMENDS;SUGGESTS" "" ${ARGN})
  list(APPEND CPACK_COMPONENTS_ALL ${name})
  string(TOUPPER ${name} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${ARG_SECTION})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${ARG_SUMMARY}\n${ARG_DESCRIPTION}")
  foreach(field IN ITEMS DEPENDS RECOMMENDS SUGGESTS)
    set(CPACK_DEBIAN_${upper}_PACKAGE_${field} "${ARG_${field}}")
  endforeach()
  if(ARG_ALL)
    set(CPACK_DEBIAN_${upper}_PACKAGE_ARCHITECTURE all)
  endif()
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DOCDIR}/../${name} COMPONENT ${name})
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${name}.lintian-overrides)
    install(FILES ${name}.lintian-overrides RENAME ${name}
      DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${name})
  endif()
endmacro()

set(same "(= ${CPACK_PACKAGE_VERSION})")
oncard_package(oncard SECTION devel
  DEPENDS "${ONCARD_LIBRARY_COMPONENT} ${same}"
  RECOMMENDS "libgts-dev ${same}"
  SUGGESTS "oncard-doc, g++, gnuplot-nox"
  SUMMARY "toolchain and simulator for Googol motion controllers"
  DESCRIPTION "\
Writes, runs, plots and verifies motion programs for Googol GTS cards\n\
without the card, and runs host programs for GTS, GE and GT400 cards.\n\
\n\
The simulation is deterministic: the same program with the same inputs\n\
computes the same bytes. Every schedule of the threads of a program can\n\
be searched.")
# One package for the libraries of all families: they are made of the same sources, and change
# their interface together.
oncard_package(${ONCARD_LIBRARY_COMPONENT} SECTION libs
  SUMMARY "host libraries of simulated Googol motion controllers"
  DESCRIPTION "\
Host programs call their card by these libraries, which simulate it:\n\
libgts for GTS cards, libgep and libges for GE cards, libgt400 for GT400\n\
cards.")
oncard_package(libgts-dev SECTION libdevel
  DEPENDS "${ONCARD_LIBRARY_COMPONENT} ${same}"
  SUGGESTS "oncard, pkg-config, cmake"
  SUMMARY "headers for host programs of Googol motion controllers"
  DESCRIPTION "\
The headers of the cards, as gts.h, in C, what linkers need, and files for\n\
CMake and pkg-config.\n\
\n\
Host programs that were written for Windows or DOS find windows.h, conio.h\n\
and others that they need.")
oncard_package(oncard-doc ALL SECTION doc
  SUMMARY "documentation and samples of oncard"
  DESCRIPTION "\
Tutorials, guides and references in English and Chinese, as Markdown, and\n\
samples with their scenarios, in teaching order.")

if(ONCARD_PYTHON)
  # Its module is for one version of Python, that of the system (python/CMakeLists.txt).
  set(Python_EXECUTABLE /usr/bin/python3)
  find_package(Python REQUIRED COMPONENTS Interpreter)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  oncard_package(python3-oncard SECTION python
    DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy, python3-tomli-w"
    SUGGESTS "oncard-doc, python3-pandas, python3-pytest"
    SUMMARY "motion programs for Googol motion controllers in Python"
    DESCRIPTION "\
Compiles, runs and explores motion programs from Python, and drives their\n\
runs forward and back. Traces are arrays of numpy, and scenarios can be\n\
tests of pytest.")
  # Python's compiled files come and go with the package.
  set(CPACK_DEBIAN_PYTHON3-ONCARD_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_SOURCE_DIR}/python3/postinst ${CMAKE_CURRENT_SOURCE_DIR}/python3/prerm)
endif()

# The documentation, in the folders of the sources, so that its links lead somewhere. Only what git
# knows: runs leave files beside samples.
execute_process(
  COMMAND git ls-files README.md README.zh-CN.md CONTRIBUTING.md docs samples
    web/lessons/README.md web/lessons/src/lesson.schema.json
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE pages COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "\n" ";" pages "${pages}")
list(FILTER pages EXCLUDE REGEX "^docs/site/|CMakeLists.txt$|^$")
set(doc_dir ${CMAKE_INSTALL_DOCDIR}/../oncard-doc)
foreach(page IN LISTS pages)
  get_filename_component(folder ${page} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${doc_dir}/${folder} COMPONENT oncard-doc)
endforeach()
file(CREATE_LINK copyright ${CMAKE_CURRENT_BINARY_DIR}/LICENSE SYMBOLIC)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/LICENSE DESTINATION ${doc_dir} COMPONENT oncard-doc)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE oncard)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
# CPack gives a package whose libraries it has examined scripts that call ldconfig. Debian has a
# trigger for that, so what libgts1 needs is found out otherwise.
string(TOUPPER ${ONCARD_LIBRARY_COMPONENT} upper)
set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS OFF)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/library_depends.cmake)
get_property(libraries GLOBAL PROPERTY ONCARD_HOST_LIBRARIES)
foreach(library IN LISTS libraries)
  list(APPEND shlibs "lib${library} ${ONCARD_SOVERSION} ${ONCARD_LIBRARY_COMPONENT} (>= ${CPACK_PACKAGE_VERSION})")
endforeach()
list(JOIN shlibs "\n" shlibs)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/shlibs "${shlibs}\n")
set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA
  ${CMAKE_CURRENT_SOURCE_DIR}/triggers ${CMAKE_CURRENT_BINARY_DIR}/shlibs)
set(CPACK_ONCARD_LIBRARY_COMPONENT ${ONCARD_LIBRARY_COMPONENT})
include(CPack)
