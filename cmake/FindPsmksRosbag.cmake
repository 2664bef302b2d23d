# find_package(PsmksRosbag): the library of ROS 1 that reads bags, and the messages that psmks reads, as Debian
# packages them (librosbag-storage-dev, libsensor-msgs-dev, libnav-msgs-dev, libtf2-msgs-dev), as the target
# psmks_ros_bags. Its own CMake and pkg-config files need parts of ROS that Debian does not have.

find_path(PsmksRosbag_INCLUDE_DIR rosbag/bag.h)
find_path(PsmksRosbag_SCAN_DIR sensor_msgs/LaserScan.h)
find_path(PsmksRosbag_ODOMETRY_DIR nav_msgs/Odometry.h)
find_path(PsmksRosbag_TRANSFORM_DIR tf2_msgs/TFMessage.h)
set(PsmksRosbag_required PsmksRosbag_INCLUDE_DIR PsmksRosbag_SCAN_DIR PsmksRosbag_ODOMETRY_DIR
  PsmksRosbag_TRANSFORM_DIR)
set(PsmksRosbag_libraries)
foreach(library IN ITEMS rosbag_storage roscpp_serialization rostime cpp_common console_bridge)
  find_library(PsmksRosbag_${library} ${library})
  list(APPEND PsmksRosbag_required PsmksRosbag_${library})
  list(APPEND PsmksRosbag_libraries "${PsmksRosbag_${library}}")
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PsmksRosbag REQUIRED_VARS ${PsmksRosbag_required})

if(PsmksRosbag_FOUND AND NOT TARGET psmks_ros_bags)
  add_library(psmks_ros_bags INTERFACE IMPORTED)
  # The headers include some of other packages by names below folders of their own.
  set(PsmksRosbag_folders "${PsmksRosbag_INCLUDE_DIR}")
  foreach(package IN ITEMS pluginlib class_loader rcutils rcpputils ament_index_cpp)
    list(APPEND PsmksRosbag_folders "${PsmksRosbag_INCLUDE_DIR}/${package}")
  endforeach()
  set_target_properties(psmks_ros_bags PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${PsmksRosbag_folders}"
    INTERFACE_LINK_LIBRARIES "${PsmksRosbag_libraries}")
endif()
