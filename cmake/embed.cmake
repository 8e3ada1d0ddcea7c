# Writes files into a C++ source, so that a program has them without looking for them.
#
#   cmake -DOUTPUT=page_parts.cpp -DFILES=page.html,page.css -P embed.cmake
#
# A font becomes an array of its bytes: Sans.ttf is const unsigned char Sans_ttf[]. Each other file becomes
# a function that returns its text: page.html is std::string page_html().
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" files "${FILES}")
set(code "// Written by cmake/embed.cmake.\n#include <string>\n\nnamespace rastertrace {\n")
foreach(path IN LISTS files)
  get_filename_component(name "${path}" NAME)
  string(REGEX REPLACE "[.-]" "_" name "${name}")
  if(path MATCHES "\\.ttf$")
    file(READ "${path}" bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    string(APPEND code "\nextern const unsigned char ${name}[];\nconst unsigned char ${name}[] = {${bytes}};\n")
    continue()
  endif()
  string(APPEND code "\nstd::string ${name}() {\n    std::string text;\n")
  file(READ "${path}" text)
  string(LENGTH "${text}" length)
  # Compilers have a limit to how long a string literal may be. A part ends with a line, not within a letter.
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${text}" ${begin} 8000 part)
    string(FIND "${part}" "\n" last REVERSE)
    if(last EQUAL -1)
      message(FATAL_ERROR "${path}: expected lines of at most 8000 bytes, found a longer one")
    endif()
    math(EXPR size "${last} + 1")
    string(SUBSTRING "${part}" 0 ${size} part)
    string(APPEND code "    text += R\"embedded(${part})embedded\";\n")
    math(EXPR begin "${begin} + ${size}")
  endwhile()
  string(APPEND code "    return text;\n}\n")
endforeach()
string(APPEND code "\n} // namespace rastertrace\n")
file(WRITE "${OUTPUT}" "${code}")
