# Libraries of the browser's build: from source, and header-only ones copied from the host so that
# none of its other headers are visible.
add_compile_options(-fwasm-exceptions)
add_link_options(-fwasm-exceptions)

set(EDGESHADE_HOST_HEADERS ${PROJECT_BINARY_DIR}/host_headers)
foreach(header glm/glm.hpp nlohmann/json.hpp tiny_gltf.h stb/stb_image.h)
  string(REGEX REPLACE "/.*" "" copied ${header})
  find_path(EDGESHADE_WITH_${copied} ${header} PATHS /usr/include /usr/local/include
    NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(COPY ${EDGESHADE_WITH_${copied}}/${copied} DESTINATION ${EDGESHADE_HOST_HEADERS})
endforeach()
foreach(target glm::glm nlohmann_json::nlohmann_json Boost::headers)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${EDGESHADE_HOST_HEADERS})
endforeach()
# Boost has many headers, so they are linked.
find_path(EDGESHADE_WITH_boost boost/version.hpp PATHS /usr/include /usr/local/include
  NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
file(CREATE_LINK ${EDGESHADE_WITH_boost}/boost ${EDGESHADE_HOST_HEADERS}/boost SYMBOLIC)
set(TINYGLTF_INCLUDE_DIR ${EDGESHADE_HOST_HEADERS})
set(STB_INCLUDE_DIR ${EDGESHADE_HOST_HEADERS}/stb)

include(cmake/LibrariesFromSource.cmake)
