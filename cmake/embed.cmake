# Writes text files into a C++ source, so that a program has them without looking for them.
#
#   cmake -DOUTPUT=page_parts.cpp -DFILES=page.html,page.css -P embed.cmake
#
# FILES are ASCII. Each becomes a function that returns its text: page.html is std::string page_html().
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" files "${FILES}")
set(code "// Written by cmake/embed.cmake.\n#include <string>\n\nnamespace rastertrace {\n")
foreach(path IN LISTS files)
  get_filename_component(name "${path}" NAME)
  string(REPLACE "." "_" name "${name}")
  string(APPEND code "\nstd::string ${name}() {\n    std::string text;\n")
  file(READ "${path}" text)
  string(LENGTH "${text}" length)
  # Compilers have a limit to how long a string literal may be.
  set(chunk 8000)
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${text}" ${begin} ${chunk} part)
    string(APPEND code "    text += R\"embedded(${part})embedded\";\n")
    math(EXPR begin "${begin} + ${chunk}")
  endwhile()
  string(APPEND code "    return text;\n}\n")
endforeach()
string(APPEND code "\n} // namespace rastertrace\n")
file(WRITE "${OUTPUT}" "${code}")
