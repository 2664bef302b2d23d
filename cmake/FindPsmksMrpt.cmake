# find_package(PsmksMrpt COMPONENTS slam [gui]): MRPT 3 (packages mrpt_slam, ...) or MRPT 2 (packages
# mrpt-slam, ...) under one set of names:
#
#   psmks_mrpt_slam   matching, maps, observations, poses
#   psmks_mrpt_gui    3D windows
#
# Installed beside psmksConfig.cmake, because psmks::psmks links psmks_mrpt_slam.

macro(psmks_find_mrpt_generation separator)
  set(PsmksMrpt_generation_complete TRUE)
  foreach(module IN LISTS PsmksMrpt_FIND_COMPONENTS)
    find_package(mrpt${separator}${module} QUIET)
    if(NOT mrpt${separator}${module}_FOUND)
      set(PsmksMrpt_generation_complete FALSE)
    endif()
  endforeach()
endmacro()

psmks_find_mrpt_generation("_")
if(PsmksMrpt_generation_complete)
  set(PsmksMrpt_target_prefix mrpt::mrpt_)
  set(PsmksMrpt_VERSION ${mrpt_slam_VERSION})
else()
  psmks_find_mrpt_generation("-")
  if(PsmksMrpt_generation_complete)
    set(PsmksMrpt_target_prefix mrpt::)
    set(PsmksMrpt_VERSION ${mrpt-slam_VERSION})
  endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PsmksMrpt
  REQUIRED_VARS PsmksMrpt_target_prefix
  VERSION_VAR PsmksMrpt_VERSION
  REASON_FAILURE_MESSAGE "neither MRPT 3 (mrpt_slam) nor MRPT 2 (mrpt-slam) was found, \
on Debian: apt install libmrpt-dev")

if(PsmksMrpt_FOUND)
  foreach(module IN LISTS PsmksMrpt_FIND_COMPONENTS)
    if(NOT TARGET psmks_mrpt_${module})
      add_library(psmks_mrpt_${module} INTERFACE IMPORTED)
      set_property(TARGET psmks_mrpt_${module} PROPERTY
        INTERFACE_LINK_LIBRARIES ${PsmksMrpt_target_prefix}${module})
    endif()
  endforeach()
endif()
