# Writes a source with the text of a file, as the answer of a function:
#
#     cmake -D FROM=rastertrace.js -D TO=module_text.cpp -P embed.cmake
file(READ ${FROM} text)
foreach(forbidden IN ITEMS ")module\"" "</script")
  string(FIND "${text}" "${forbidden}" place)
  if(NOT place EQUAL -1)
    message(FATAL_ERROR "${FROM} holds ${forbidden}")
  endif()
endforeach()
file(WRITE ${TO} "#include <rastertrace/wasm/module.h>

namespace rastertrace {

std::string_view wasm_module() {
    static constexpr char text[] = R\"module(")
file(APPEND ${TO} "${text}")
file(APPEND ${TO} ")module\";
    return {text, sizeof text - 1};
}

} // namespace rastertrace
")
