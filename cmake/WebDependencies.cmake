# What the browser's build links, for WebAssembly: Draco and a part of meshoptimizer built from
# source, header-only libraries copied from the host so that none of its other headers are seen.
include(FetchContent)
add_compile_options(-fwasm-exceptions)
add_link_options(-fwasm-exceptions)

set(EDGESHADE_HOST_HEADERS ${PROJECT_BINARY_DIR}/host_headers)
foreach(header glm/glm.hpp nlohmann/json.hpp tiny_gltf.h stb/stb_image.h)
  string(REGEX REPLACE "/.*" "" copied ${header})
  find_path(EDGESHADE_WITH_${copied} ${header} PATHS /usr/include /usr/local/include
    NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(COPY ${EDGESHADE_WITH_${copied}}/${copied} DESTINATION ${EDGESHADE_HOST_HEADERS})
endforeach()
foreach(target glm::glm nlohmann_json::nlohmann_json)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${EDGESHADE_HOST_HEADERS})
endforeach()
set(TINYGLTF_INCLUDE_DIR ${EDGESHADE_HOST_HEADERS})
set(STB_INCLUDE_DIR ${EDGESHADE_HOST_HEADERS}/stb)

# Debian's source packages where ./run has fetched them, else the same versions from upstream.
foreach(library draco meshoptimizer)
  string(TOUPPER ${library} upper)
  if(EXISTS ${PROJECT_SOURCE_DIR}/build/web-sources/${library})
    set(FETCHCONTENT_SOURCE_DIR_${upper} ${PROJECT_SOURCE_DIR}/build/web-sources/${library})
  endif()
endforeach()
FetchContent_Declare(draco GIT_REPOSITORY https://github.com/google/draco GIT_TAG 1.5.5
  GIT_SUBMODULES "")
FetchContent_Declare(meshoptimizer GIT_REPOSITORY https://github.com/zeux/meshoptimizer
  GIT_TAG v0.18)

FetchContent_GetProperties(draco)
if(NOT draco_POPULATED)
  FetchContent_Populate(draco)
  set(DRACO_WASM ON CACHE BOOL "" FORCE)
  set(DRACO_JS_GLUE OFF CACHE BOOL "" FORCE)
  get_filename_component(emscripten_folder ${CMAKE_CXX_COMPILER} REALPATH)
  get_filename_component(emscripten_folder ${emscripten_folder} DIRECTORY)
  set(ENV{EMSCRIPTEN} ${emscripten_folder}) # its CMake asks for it
  add_subdirectory(${draco_SOURCE_DIR} ${draco_BINARY_DIR} EXCLUDE_FROM_ALL)
  target_include_directories(draco_static SYSTEM INTERFACE
    $<BUILD_INTERFACE:${draco_SOURCE_DIR}/src> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}>)
  # Of its library only what decodes: the rest would be compiled to be thrown away by the linker.
  get_target_property(draco_parts draco_static SOURCES)
  list(FILTER draco_parts EXCLUDE REGEX "_(enc|encode|enc_config|options|io|animation|animation_dec)>")
  set_property(TARGET draco_static PROPERTY SOURCES ${draco_parts})
endif()

FetchContent_GetProperties(meshoptimizer)
if(NOT meshoptimizer_POPULATED)
  FetchContent_Populate(meshoptimizer)
  set(part ${meshoptimizer_SOURCE_DIR}/src)
  add_library(meshoptimizer_part STATIC EXCLUDE_FROM_ALL ${part}/allocator.cpp
    ${part}/indexcodec.cpp ${part}/indexgenerator.cpp ${part}/simplifier.cpp
    ${part}/vertexcodec.cpp ${part}/vertexfilter.cpp)
  target_include_directories(meshoptimizer_part SYSTEM PUBLIC ${part})
  add_library(meshoptimizer::meshoptimizer ALIAS meshoptimizer_part)
endif()
