# The package that find_package(psmks) reads.
include(CMakePackageConfigHelpers)

set(psmks_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/psmks)

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/psmksConfig.cmake.in" "${PROJECT_BINARY_DIR}/psmksConfig.cmake"
  INSTALL_DESTINATION ${psmks_package_dir})
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/psmksConfigVersion.cmake" COMPATIBILITY SameMinorVersion)

install(EXPORT psmksTargets NAMESPACE psmks:: DESTINATION ${psmks_package_dir})
install(FILES
  "${PROJECT_BINARY_DIR}/psmksConfig.cmake"
  "${PROJECT_BINARY_DIR}/psmksConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindPsmksMrpt.cmake"
  DESTINATION ${psmks_package_dir})
install(FILES package.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/psmks)
install(DIRECTORY config DESTINATION ${CMAKE_INSTALL_DATADIR}/psmks)
