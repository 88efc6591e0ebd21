# cmake --install puts the command, the library, its headers and what find_package(arris) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(ARRIS_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/arris)
install(TARGETS arris EXPORT arrisTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET arris_cli)
  install(TARGETS arris_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY include/arris DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(EXPORT arrisTargets NAMESPACE arris:: DESTINATION ${ARRIS_CMAKE_DIR})

# A static library leaves its own libraries to the consumer to link: see the template.
get_target_property(arris_type arris TYPE)
if(arris_type STREQUAL "STATIC_LIBRARY")
  set(ARRIS_IS_STATIC TRUE)
else()
  set(ARRIS_IS_STATIC FALSE)
endif()
configure_package_config_file(cmake/arrisConfig.cmake.in ${CMAKE_BINARY_DIR}/arrisConfig.cmake
  INSTALL_DESTINATION ${ARRIS_CMAKE_DIR})
# 0.x may change the API with every minor version.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/arrisConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/arrisConfig.cmake ${CMAKE_BINARY_DIR}/arrisConfigVersion.cmake
  DESTINATION ${ARRIS_CMAKE_DIR})
