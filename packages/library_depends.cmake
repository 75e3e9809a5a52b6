# What the package of the host libraries needs: cpack runs this when the files are where they will be
# packed.
set(component ${CPACK_ONCARD_LIBRARY_COMPONENT})
set(folder ${CPACK_TEMPORARY_DIRECTORY}/${component})
file(GLOB libraries LIST_DIRECTORIES false ${folder}/usr/lib/*/lib*.so.*)
# dpkg-shlibdeps looks for a file of the sources, and for a folder of the package.
file(WRITE ${folder}/debian/control "")
file(MAKE_DIRECTORY ${folder}/DEBIAN)
execute_process(COMMAND dpkg-shlibdeps -O ${libraries}
  WORKING_DIRECTORY ${folder} OUTPUT_VARIABLE depends OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${folder}/debian ${folder}/DEBIAN)
string(REGEX REPLACE "^shlibs:Depends=" "" depends "${depends}")
string(TOUPPER ${component} component)
set(CPACK_DEBIAN_${component}_PACKAGE_DEPENDS "${depends}")
