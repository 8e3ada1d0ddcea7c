# Debian's libzstd-dev ships no CMake configuration. Defines Zstd::zstd.
find_path(ZSTD_INCLUDE_DIR zstd.h)
find_library(ZSTD_LIBRARY zstd)
mark_as_advanced(ZSTD_INCLUDE_DIR ZSTD_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Zstd
  REQUIRED_VARS ZSTD_LIBRARY ZSTD_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "install libzstd-dev")

if(Zstd_FOUND AND NOT TARGET Zstd::zstd)
  add_library(Zstd::zstd INTERFACE IMPORTED)
  target_include_directories(Zstd::zstd INTERFACE ${ZSTD_INCLUDE_DIR})
  target_link_libraries(Zstd::zstd INTERFACE ${ZSTD_LIBRARY})
endif()
