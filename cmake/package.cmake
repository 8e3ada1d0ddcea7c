# cpack -G DEB makes two packages for Debian of what is installed: the program, and the libraries. scripts/package.sh
# calls it.
set(CPACK_PACKAGE_CONTACT "The rastertrace authors <maintainers@rastertrace.invalid>")
set(CPACK_PACKAGE_DESCRIPTION "It draws a scene with the textbook's algorithm, writes down every decision\n\
with the numbers that made it, and shows them step by step: as text, as\n\
figures and pages, as explanations. It checks what was worked out by hand,\n\
and compares the decisions of two renderers.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME rastertrace)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME librastertrace-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "rastertrace (= ${PROJECT_VERSION}), libfmt-dev, libglm-dev, libgmp-dev, libpng-dev, libunistring-dev")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION ${CPACK_PACKAGE_DESCRIPTION})
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Libraries and headers of rastertrace: rasterization algorithms and\nthe traces of their decisions.")
include(CPack)
