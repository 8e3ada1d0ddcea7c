# `cmake --install` puts in place what is built: the libraries and what find_package(rastertrace) and pkg-config need,
# the program with its pages of the manual and completions, and examples, schemas, styles and docs.
# Components: program, development.
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/rastertrace)
set(share_dir ${CMAKE_INSTALL_DATADIR}/rastertrace)
set(doc_dir ${CMAKE_INSTALL_DATADIR}/doc/rastertrace)
set(doc_dir_of_development ${CMAKE_INSTALL_DATADIR}/doc/librastertrace-dev)

set(libraries rastertrace_core rastertrace_draw)
set(find_modules ${CMAKE_CURRENT_LIST_DIR}/FindGMP.cmake)
if(RASTERTRACE_BUILD_TRACE)
  list(APPEND libraries ${rastertrace_rooms} rastertrace_trace rastertrace_emit)
  list(APPEND find_modules ${CMAKE_CURRENT_LIST_DIR}/FindUnistring.cmake)
endif()
# Before anything is put in place: what of a component is not built yet.
function(expect_built component)
  install(CODE "set(files \"${ARGN}\")
  foreach(file IN LISTS files)
    if(NOT EXISTS \"\${file}\")
      message(FATAL_ERROR \"expected \${file} to be built, found no such file. This builds all that is installed:\"
        \"\\n  cmake --build ${PROJECT_BINARY_DIR}\")
    endif()
  endforeach()" COMPONENT ${component})
endfunction()
if(RASTERTRACE_BUILD_PROGRAM)
  expect_built(program $<TARGET_FILE:rastertrace_program>)
  if(NOT CMAKE_CROSSCOMPILING)
    expect_built(program ${PROJECT_BINARY_DIR}/manual/changelog.gz ${PROJECT_BINARY_DIR}/trace/figures/raster-trace.js)
  endif()
endif()
foreach(library IN LISTS libraries ITEMS rastertrace_testing)
  if(TARGET ${library})
    get_target_property(type ${library} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      expect_built(development $<TARGET_FILE:${library}>)
    endif()
  endif()
endforeach()

# The libraries that a program finds by one export.
function(install_libraries export)
  set_target_properties(${ARGN} PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  install(TARGETS ${ARGN} EXPORT ${export} FILE_SET HEADERS COMPONENT development
    ARCHIVE COMPONENT development
    LIBRARY COMPONENT program NAMELINK_COMPONENT development)
  install(EXPORT ${export} NAMESPACE rastertrace:: DESTINATION ${package_dir} COMPONENT development)
endfunction()

install_libraries(rastertrace-targets ${libraries})
if(RASTERTRACE_BUILD_PROGRAM)
  install(TARGETS rastertrace_program EXPORT rastertrace-targets COMPONENT program)
endif()
# What needs GoogleTest has an export of its own: nobody else looks for GoogleTest.
if(TARGET rastertrace_testing)
  install_libraries(rastertrace-testing-targets rastertrace_testing)
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/rastertrace-config-version.cmake.in rastertrace-config-version.cmake @ONLY)
install(FILES
    ${CMAKE_CURRENT_LIST_DIR}/rastertrace-config.cmake
    ${CMAKE_CURRENT_LIST_DIR}/rastertrace-golden.cmake
    ${CMAKE_CURRENT_LIST_DIR}/golden-test.cmake
    ${find_modules}
    ${CMAKE_CURRENT_BINARY_DIR}/rastertrace-config-version.cmake
  DESTINATION ${package_dir} COMPONENT development)

if(RASTERTRACE_BUILD_TRACE)
  # A library comes before those that it uses.
  set(library_flags rastertrace_core rastertrace_draw ${rastertrace_rooms})
  list(REVERSE library_flags)
  list(TRANSFORM library_flags PREPEND -l)
  list(JOIN library_flags " " library_flags)
  get_target_property(core_options rastertrace_core INTERFACE_COMPILE_OPTIONS)
  file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/rastertrace.pc.in rastertrace.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rastertrace.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endif()
install(FILES LICENSE DESTINATION ${doc_dir_of_development} COMPONENT development RENAME copyright)
if(NOT RASTERTRACE_BUILD_PROGRAM)
  return()
endif()

install(DIRECTORY examples DESTINATION ${share_dir} COMPONENT program)
install(FILES docs/claims.schema.json docs/scene.schema.json docs/trace.schema.json
  DESTINATION ${share_dir}/schemas COMPONENT program)
install(FILES examples/figures/rastertrace.sty DESTINATION ${share_dir}/styles COMPONENT program)
install(FILES viewer-cli/python/rastertrace.py DESTINATION ${share_dir} COMPONENT program)
install(FILES LICENSE DESTINATION ${doc_dir} COMPONENT program RENAME copyright)
install(FILES trace/figures/font/LICENSE DESTINATION ${doc_dir} COMPONENT program RENAME copyright.DejaVu)
install(FILES README.md CHANGELOG.md DESTINATION ${doc_dir} COMPONENT program)
install(DIRECTORY docs DESTINATION ${doc_dir} COMPONENT program PATTERN site EXCLUDE)
if(RASTERTRACE_WASM)
  set(module ${PROJECT_BINARY_DIR}/viewer-cli/page/module/rastertrace)
  install(FILES ${module}.js ${module}.mjs ${module}.wasm DESTINATION ${share_dir} COMPONENT program)
endif()

# The program writes its manual. One for another machine cannot be run here.
if(NOT CMAKE_CROSSCOMPILING)
  install(FILES ${PROJECT_BINARY_DIR}/trace/figures/raster-trace.js DESTINATION ${share_dir} COMPONENT program)
  set(manual ${PROJECT_BINARY_DIR}/manual)
  add_custom_command(OUTPUT ${manual}/changelog.gz
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:rastertrace_program> -DCHANGES=${PROJECT_SOURCE_DIR}/CHANGELOG.md
      -DFOLDER=${manual} -P ${CMAKE_CURRENT_LIST_DIR}/manual.cmake
    DEPENDS rastertrace_program CHANGELOG.md ${CMAKE_CURRENT_LIST_DIR}/manual.cmake VERBATIM)
  add_custom_target(rastertrace_manual ALL DEPENDS ${manual}/changelog.gz)
  install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
  install(FILES ${manual}/changelog.gz DESTINATION ${doc_dir} COMPONENT program)
  install(FILES ${manual}/changelog.gz DESTINATION ${doc_dir_of_development} COMPONENT development)
  foreach(file IN ITEMS bash-completion/completions/rastertrace=bash zsh/site-functions/_rastertrace=zsh
      fish/vendor_completions.d/rastertrace.fish=fish)
    string(REGEX MATCH "(.*)/(.*)=(.*)" ignored ${file})
    install(FILES ${manual}/${CMAKE_MATCH_3} DESTINATION ${CMAKE_INSTALL_DATADIR}/${CMAKE_MATCH_1}
      RENAME ${CMAKE_MATCH_2} COMPONENT program)
  endforeach()
endif()

if(PROJECT_IS_TOP_LEVEL)
  include(${CMAKE_CURRENT_LIST_DIR}/package.cmake)
endif()
