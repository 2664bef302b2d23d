# A library of psmks, made of folders below psmks/: its target, the alias psmks::<name>, the include path
# <psmks/...>, C++17, warnings, and its installation with the headers that lie beside its sources.
#
#   psmks_add_library(core STATIC FOLDERS geometry base)     # target psmks_core, psmks::core
function(psmks_add_library name kind)
  cmake_parse_arguments(LIBRARY "" "TARGET" "FOLDERS" ${ARGN})
  set(target psmks_${name})
  if(LIBRARY_TARGET)
    set(target ${LIBRARY_TARGET})
  endif()
  list(TRANSFORM LIBRARY_FOLDERS APPEND "/*.cpp" OUTPUT_VARIABLE patterns)
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})

  add_library(${target} ${kind} ${sources})
  add_library(psmks::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  psmks_target_warnings(${target})

  install(TARGETS ${target}
    EXPORT psmksTargets
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  foreach(folder IN LISTS LIBRARY_FOLDERS)
    install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/"
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/psmks/${folder}
      FILES_MATCHING PATTERN "*.h")
  endforeach()
endfunction()
