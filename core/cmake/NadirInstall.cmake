# Installs the program, its bundled maps and resources, and `nadir::core` for find_package(nadir).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY NADIR_MODULES)
install(TARGETS nadir_core ${modules} EXPORT nadirTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS nadir RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS nadir_film LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/nadir)
set_target_properties(nadir PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}/nadir")
include(core/cmake/NadirPrivateHeaders.cmake)
set(private_headers)
foreach(header IN LISTS NADIR_PRIVATE_HEADERS)
  list(APPEND private_headers PATTERN ${header} EXCLUDE)
endforeach()
install(DIRECTORY core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/nadir FILES_MATCHING PATTERN "*.h" ${private_headers})
install(DIRECTORY ${PROJECT_BINARY_DIR}/generated/core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/nadir
  FILES_MATCHING PATTERN "*.h")
install(DIRECTORY maps/proving-ground DESTINATION ${CMAKE_INSTALL_DATADIR}/nadir/maps)
install(DIRECTORY resources DESTINATION ${CMAKE_INSTALL_DATADIR}/nadir)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/nadir)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/nadir)
install(EXPORT nadirTargets NAMESPACE nadir:: DESTINATION ${config_folder})
configure_package_config_file(core/cmake/nadirConfig.cmake.in ${PROJECT_BINARY_DIR}/nadirConfig.cmake
  INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/nadirConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/nadirConfig.cmake ${PROJECT_BINARY_DIR}/nadirConfigVersion.cmake
  core/cmake/NadirDependencies.cmake DESTINATION ${config_folder})
