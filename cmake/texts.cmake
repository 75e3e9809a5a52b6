# cmake -D OUTPUT=file -D TEXTS=file;... -P texts.cmake: the rows of a table of C++, a name and a text for
# each file. See oncard_texts().
set(rows "// Written by cmake/texts.cmake.\n")
foreach(file IN LISTS TEXTS)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND rows "{\"${name}\", R\"text(${text})text\"},\n")
endforeach()
file(WRITE ${OUTPUT} "${rows}")
