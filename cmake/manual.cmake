# Lets the program write its pages of the manual and the completions of shells; pages and changes are compressed, as
# man and Debian have them.
#
#   cmake -DPROGRAM=rastertrace -DCHANGES=CHANGELOG.md -DFOLDER=build/manual -P manual.cmake
cmake_minimum_required(VERSION 3.25)
function(write file)
  execute_process(COMMAND ${PROGRAM} help ${ARGN} OUTPUT_FILE ${FOLDER}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${FOLDER}) # a command that is gone leaves no page
file(MAKE_DIRECTORY ${FOLDER}/man1)
write(man1/rastertrace.1 --man)
execute_process(COMMAND ${PROGRAM} help -- "" OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[a-z-]+" commands "${commands}")
foreach(command IN LISTS commands)
  write(man1/rastertrace-${command}.1 --man ${command})
endforeach()
foreach(shell IN ITEMS bash zsh fish)
  write(${shell} --completion ${shell})
endforeach()
file(COPY_FILE ${CHANGES} ${FOLDER}/changelog)
file(GLOB pages ${FOLDER}/man1/*)
execute_process(COMMAND gzip -9n ${pages} ${FOLDER}/changelog COMMAND_ERROR_IS_FATAL ANY)
