# `cmake --install` puts the program, the libraries and what find_package(rastertrace) needs in place.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/rastertrace)

install(TARGETS rastertrace_core rastertrace_draw ${rastertrace_rooms} rastertrace_trace rastertrace_emit rastertrace_program
  EXPORT rastertrace-targets FILE_SET HEADERS)
install(EXPORT rastertrace-targets NAMESPACE rastertrace:: DESTINATION ${package_dir})
# What needs GoogleTest has an export of its own: nobody else looks for GoogleTest.
if(TARGET rastertrace_testing)
  install(TARGETS rastertrace_testing EXPORT rastertrace-testing-targets FILE_SET HEADERS)
  install(EXPORT rastertrace-testing-targets NAMESPACE rastertrace:: DESTINATION ${package_dir})
endif()
write_basic_package_version_file(rastertrace-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${CMAKE_CURRENT_LIST_DIR}/rastertrace-config.cmake
    ${CMAKE_CURRENT_LIST_DIR}/rastertrace-golden.cmake
    ${CMAKE_CURRENT_LIST_DIR}/golden-test.cmake
    ${CMAKE_CURRENT_LIST_DIR}/FindGMP.cmake
    ${CMAKE_CURRENT_LIST_DIR}/FindUnistring.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/rastertrace-config-version.cmake
  DESTINATION ${package_dir})
