# cmake --install: the program with its manual page and completion, the libraries with the headers
# in include/, and the files for find_package() and pkg-config (docs/engine.md).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(EDGESHADE_LIBRARIES edgeshade_geometry edgeshade_preprocess edgeshade_image
  edgeshade_environment edgeshade_shadow edgeshade_runtime)
foreach(library ${EDGESHADE_LIBRARIES})
  string(REPLACE edgeshade_ "" part ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${part} POSITION_INDEPENDENT_CODE ON)
endforeach()
set_target_properties(edgeshade_runtime PROPERTIES EXPORT_NAME edgeshade OUTPUT_NAME edgeshade)

# Components: `program` and `development`, a Debian package each (cmake/Packages.cmake).
install(TARGETS edgeshade RUNTIME COMPONENT program)
install(TARGETS ${EDGESHADE_LIBRARIES} EXPORT edgeshadeTargets ARCHIVE COMPONENT development
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/edgeshade TYPE INCLUDE COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  ${PROJECT_SOURCE_DIR}/cmake/LICENSE.glu TYPE DOC COMPONENT program)

# The program's own table of options writes the manual page and the completion for bash. When a
# build for another processor can't run that, they are left out.
if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
  message(STATUS "No manual page and no completion: programs of this build don't run here")
else()
  set(manual ${PROJECT_BINARY_DIR}/documents/edgeshade.1)
  set(completion ${PROJECT_BINARY_DIR}/documents/edgeshade.bash)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/documents)
  add_custom_command(OUTPUT ${manual} COMMAND edgeshade_documents man ${manual}
    DEPENDS edgeshade_documents VERBATIM)
  add_custom_command(OUTPUT ${completion} COMMAND edgeshade_documents bash ${completion}
    DEPENDS edgeshade_documents VERBATIM)
  add_custom_target(edgeshade_manual ALL DEPENDS ${manual} ${completion})
  install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${completion} RENAME edgeshade COMPONENT program
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endif()

set(EDGESHADE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/edgeshade)
install(EXPORT edgeshadeTargets NAMESPACE edgeshade:: DESTINATION ${EDGESHADE_CMAKE_DIR}
  COMPONENT development)
configure_package_config_file(cmake/edgeshadeConfig.cmake.in
  ${PROJECT_BINARY_DIR}/edgeshadeConfig.cmake INSTALL_DESTINATION ${EDGESHADE_CMAKE_DIR})
# Before 1.0.0 a minor version may break its users (docs/versions.md).
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(EDGESHADE_COMPATIBLE SameMinorVersion)
else()
  set(EDGESHADE_COMPATIBLE SameMajorVersion)
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/edgeshadeConfigVersion.cmake
  COMPATIBILITY ${EDGESHADE_COMPATIBLE})
install(FILES ${PROJECT_BINARY_DIR}/edgeshadeConfig.cmake
  ${PROJECT_BINARY_DIR}/edgeshadeConfigVersion.cmake DESTINATION ${EDGESHADE_CMAKE_DIR}
  COMPONENT development)

file(RELATIVE_PATH EDGESHADE_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
set(EDGESHADE_WEBP_FLAG)
if(WEBP_LIBRARY AND WEBP_INCLUDE_DIR)
  set(EDGESHADE_WEBP_FLAG " -lwebp")
endif()
configure_file(cmake/edgeshade.pc.in ${PROJECT_BINARY_DIR}/edgeshade.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/edgeshade.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)

include(cmake/Packages.cmake)
