# A library of psmks, made of folders below psmks/: its target, the alias psmks::<name>, the include path
# <psmks/...>, C++17 and warnings.
#
#   psmks_add_library(eval STATIC FOLDERS eval)                    # target psmks_eval, psmks::eval
#   psmks_add_library(core STATIC FOLDERS geometry core
#     COMPONENT core PUBLIC_HEADERS geometry/Scan.h core/Matcher.h)
#
# With a COMPONENT it is installed, found by find_package(psmks COMPONENTS <component>), and of its headers
# those that are listed are installed with it. Without one it serves the programs and tests of psmks alone.
function(psmks_add_library name kind)
  cmake_parse_arguments(LIBRARY "" "TARGET;COMPONENT" "FOLDERS;PUBLIC_HEADERS" ${ARGN})
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
  psmks_target_unity(${target})
  if(LIBRARY_COMPONENT)
    psmks_install_library(${target} ${LIBRARY_COMPONENT} ${LIBRARY_PUBLIC_HEADERS})
  endif()
endfunction()

# psmks_install_library(target component headers...): the headers by their paths below psmks/.
function(psmks_install_library target component)
  install(TARGETS ${target}
    EXPORT psmks-${component}-targets
    COMPONENT ${component}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT psmks-${component}-targets
    NAMESPACE psmks::
    COMPONENT ${component}
    DESTINATION ${psmks_package_dir})
  foreach(header IN LISTS ARGN)
    get_filename_component(folder "${header}" DIRECTORY)
    install(FILES "${PROJECT_SOURCE_DIR}/psmks/${header}"
      COMPONENT ${component}
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/psmks/${folder})
  endforeach()
endfunction()

# A program of psmks: its version, its warnings, and its installation. `cmake --install` takes the programs
# that were built and passes over the others.
function(psmks_add_program name)
  add_executable(${name} ${ARGN})
  target_compile_definitions(${name} PRIVATE PSMKS_VERSION="${PROJECT_VERSION}")
  psmks_target_warnings(${name})
  psmks_target_unity(${name})
  install(TARGETS ${name}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs OPTIONAL)
endfunction()

# Compiles the sources of a target a dozen at a time where PSMKS_UNITY_BUILD asks for it: the whole of psmks
# in half the time, one file after a change in more. Names in unnamed namespaces have to differ then.
function(psmks_target_unity target)
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ${PSMKS_UNITY_BUILD} UNITY_BUILD_BATCH_SIZE 12)
endfunction()
