# GNU libunistring ships no CMake configuration. Defines Unistring::unistring.
find_path(UNISTRING_INCLUDE_DIR uniwidth.h)
find_library(UNISTRING_LIBRARY unistring)
mark_as_advanced(UNISTRING_INCLUDE_DIR UNISTRING_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Unistring
  REQUIRED_VARS UNISTRING_LIBRARY UNISTRING_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "install libunistring-dev")

if(Unistring_FOUND AND NOT TARGET Unistring::unistring)
  add_library(Unistring::unistring INTERFACE IMPORTED)
  target_include_directories(Unistring::unistring INTERFACE ${UNISTRING_INCLUDE_DIR})
  target_link_libraries(Unistring::unistring INTERFACE ${UNISTRING_LIBRARY})
endif()
