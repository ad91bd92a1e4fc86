# cpack, or `./run package`: two Debian packages, `edgeshade` with the program and `libedgeshade-dev`
# with the static libraries and headers, and an archive of both that runs from any folder
# (docs/packages.md).
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME edgeshade)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "edgeshade")
set(CPACK_PACKAGE_CONTACT "The edgeshade authors <authors@edgeshade.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_SOURCE_DIR}/build/packages)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_PACKAGE_FILE_NAME
  edgeshade-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME edgeshade)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# A GL that draws without a display.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libegl-mesa0, libgl1-mesa-dri")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"edgeshade draws, measures and packs glTF scenes with shadows that are exact to
the pixel, hard and soft, on OpenGL ES 2.0. It also counts hours of sunlight.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libedgeshade-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(development_dependencies libdraco-dev libmeshoptimizer-dev libegl-dev libgles-dev)
if(WEBP_LIBRARY AND WEBP_INCLUDE_DIR)
  list(APPEND development_dependencies libwebp-dev)
endif()
list(JOIN development_dependencies ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"Static libraries and headers: masks that say which pixels each light reaches,
packing of glTF scenes, silhouettes. Use them by find_package() in CMake or by
pkg-config.")

# Each Debian package also has compressed documents, a copyright file and a changelog.
string(TIMESTAMP EDGESHADE_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(packaging/debian/changelog.in ${PROJECT_BINARY_DIR}/documents/changelog.Debian @ONLY)
file(READ LICENSE EDGESHADE_LICENCE)
file(READ cmake/LICENSE.glu EDGESHADE_GLU_LICENCE)
configure_file(packaging/debian/copyright.in ${PROJECT_BINARY_DIR}/documents/copyright @ONLY)
# Libraries whose headers or archives are compiled into the program, as Debian names them. The licence
# of Boost, another one, asks for no notice in programs.
foreach(library tinygltf stb cli11 glm draco meshoptimizer)
  file(GLOB licence /usr/share/doc/lib${library}-dev/copyright)
  list(APPEND licences ${licence})
endforeach()
file(GLOB licence /usr/share/doc/nlohmann-json3-dev/copyright)
foreach(licence IN LISTS licences licence)
  cmake_path(GET licence PARENT_PATH folder)
  cmake_path(GET folder FILENAME library)
  file(READ ${licence} text)
  file(APPEND ${PROJECT_BINARY_DIR}/documents/copyright "\n${library}\n\n${text}")
endforeach()
set(CPACK_EDGESHADE_COPYRIGHT ${PROJECT_BINARY_DIR}/documents/copyright)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_files_script.cmake)
set(CPACK_EDGESHADE_CHANGELOG ${PROJECT_BINARY_DIR}/documents/changelog.Debian)
set(CPACK_EDGESHADE_SOURCE_DIR ${PROJECT_SOURCE_DIR})
set(CPACK_EDGESHADE_STRIP ${CMAKE_STRIP})
include(CPack)
