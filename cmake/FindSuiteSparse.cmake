# SuiteSparse::CHOLMOD, SuiteSparse::UMFPACK and SuiteSparse::CONFIG, whose memory both take. Debian 12 ships neither a
# CMake package nor a pkg-config file.
include(FindPackageHandleStandardArgs)

find_path(SuiteSparse_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(SuiteSparse_CHOLMOD_LIBRARY cholmod)
find_library(SuiteSparse_UMFPACK_LIBRARY umfpack)
find_library(SuiteSparse_CONFIG_LIBRARY suitesparseconfig)

if(SuiteSparse_INCLUDE_DIR)
  file(STRINGS "${SuiteSparse_INCLUDE_DIR}/SuiteSparse_config.h" _lines
       REGEX "#define SUITESPARSE_(MAIN|SUB|SUBSUB)_VERSION")
  foreach(part MAIN SUB SUBSUB)
    string(REGEX REPLACE ".*SUITESPARSE_${part}_VERSION ([0-9]+).*" "\\1" _${part} "${_lines}")
  endforeach()
  set(SuiteSparse_VERSION "${_MAIN}.${_SUB}.${_SUBSUB}")
endif()

find_package_handle_standard_args(SuiteSparse
  REQUIRED_VARS SuiteSparse_INCLUDE_DIR SuiteSparse_CHOLMOD_LIBRARY SuiteSparse_UMFPACK_LIBRARY
                SuiteSparse_CONFIG_LIBRARY
  VERSION_VAR SuiteSparse_VERSION)

if(SuiteSparse_FOUND)
  foreach(part CHOLMOD UMFPACK CONFIG)
    if(NOT TARGET SuiteSparse::${part})
      add_library(SuiteSparse::${part} UNKNOWN IMPORTED)
      set_target_properties(SuiteSparse::${part} PROPERTIES
        IMPORTED_LOCATION "${SuiteSparse_${part}_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${SuiteSparse_INCLUDE_DIR}")
    endif()
  endforeach()
endif()
