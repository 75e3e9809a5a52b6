# Where `cmake --install` and the packages (packages/) put files. The names of the components are those
# of the packages:
#
#   oncard           the command, and what it needs
#   libgts1          the host libraries of all families; the number is ONCARD_SOVERSION
#   libgts-dev       what other projects compile and link with: declarations for C and C#, links, CMake and
#                    pkg-config files
#   oncard-doc       the documentation and the samples
#   python3-oncard   the package for Python
include(GNUInstallDirs)
set(ONCARD_LIBRARY_COMPONENT libgts${ONCARD_SOVERSION})

# The folder that `oncard exec` lets a host search: the library that it loads into hosts, which nobody
# else should, and links to the host libraries, which need not be in a folder that is searched anyway.
set(ONCARD_EXEC_LIBDIR ${CMAKE_INSTALL_LIBDIR}/oncard)

# oncard_install_family(name CARDS text): what oncard_family() has made. CARDS says in a few words
# whose cards these are.
function(oncard_install_family name)
  cmake_parse_arguments(ARG "" "CARDS" "" ${ARGN})
  install(TARGETS ${name} EXPORT oncard
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
      COMPONENT ${ONCARD_LIBRARY_COMPONENT} NAMELINK_COMPONENT libgts-dev
    PUBLIC_HEADER DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT libgts-dev
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  oncard_install_pkg_config(${name} "host library of simulated ${ARG_CARDS}"
    LIBRARY ${name} INCLUDE ${CMAKE_INSTALL_INCLUDEDIR})
  foreach(link IN ITEMS lib${name}.so lib${name}.so.${ONCARD_SOVERSION})
    oncard_install_exec_link(${link} lib${name}.so.${ONCARD_SOVERSION})
  endforeach()
endfunction()

# oncard_dll_link(link library): a link to a library by the name that it has on Windows, for hosts that
# load it by that name. Called in the folder of the library.
function(oncard_dll_link link library)
  set(dll $<TARGET_FILE_DIR:${library}>/${link})
  add_custom_command(TARGET ${library} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -E create_symlink $<TARGET_FILE_NAME:${library}> ${dll} VERBATIM)
  install(FILES ${dll} DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${ONCARD_LIBRARY_COMPONENT})
  oncard_install_exec_link(${link} ${link})
endfunction()

# oncard_install_exec_link(link library): a link in the folder of `oncard exec` to an installed library.
function(oncard_install_exec_link link library)
  set(links ${PROJECT_BINARY_DIR}/exec_links)
  file(MAKE_DIRECTORY ${links})
  file(CREATE_LINK ../${library} ${links}/${link} SYMBOLIC)
  install(FILES ${links}/${link} DESTINATION ${ONCARD_EXEC_LIBDIR} COMPONENT oncard)
endfunction()

# oncard_install_pkg_config(name description [LIBRARY library] INCLUDE folder): <name>.pc.
function(oncard_install_pkg_config name description)
  cmake_parse_arguments(ARG "" "LIBRARY;INCLUDE" "" ${ARGN})
  set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  # Paths begin at the file's own folder: an installation can be moved.
  file(RELATIVE_PATH up /${folder} /)
  string(REGEX REPLACE "/$" "" up ${up})
  set(libs)
  if(ARG_LIBRARY)
    set(libs "-L\${libdir} -l${ARG_LIBRARY}")
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/pkg_config.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${folder} COMPONENT libgts-dev)
endfunction()
