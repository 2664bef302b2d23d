# The package that find_package(psmks) reads. It belongs to the component core, which every other needs.
include(CMakePackageConfigHelpers)

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/psmksConfig.cmake.in" "${PROJECT_BINARY_DIR}/psmksConfig.cmake"
  INSTALL_DESTINATION ${psmks_package_dir})
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/psmksConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/psmksConfig.cmake"
  "${PROJECT_BINARY_DIR}/psmksConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindPsmksMrpt.cmake"
  COMPONENT core
  DESTINATION ${psmks_package_dir})
install(FILES package.xml COMPONENT core DESTINATION ${CMAKE_INSTALL_DATADIR}/psmks)
install(DIRECTORY config COMPONENT programs DESTINATION ${CMAKE_INSTALL_DATADIR}/psmks)
