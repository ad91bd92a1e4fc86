# Turns every GLSL file of shaders_es2/ into a string of one generated header, and replaces
# `#include "file"` lines by that file. The shaders get no other preprocessing here; the runtime
# puts a variant's #define lines in front.
set(EDGESHADE_SHADER_DIR ${PROJECT_SOURCE_DIR}/shaders_es2)
# Shaders for techniques that pages leave out (src/rivals, src/settings/build_parts.hpp).
if(EMSCRIPTEN)
  file(GLOB_RECURSE left_out RELATIVE ${EDGESHADE_SHADER_DIR} ${EDGESHADE_SHADER_DIR}/rivals/*)
  list(APPEND left_out light_table.glsl)
  list(JOIN left_out "," EDGESHADE_SHADERS_LEFT_OUT)
endif()
set(EDGESHADE_GENERATED_DIR ${PROJECT_BINARY_DIR}/generated)
file(GLOB_RECURSE EDGESHADE_SHADER_FILES CONFIGURE_DEPENDS
  ${EDGESHADE_SHADER_DIR}/*.vert ${EDGESHADE_SHADER_DIR}/*.frag ${EDGESHADE_SHADER_DIR}/*.glsl)

add_custom_command(
  OUTPUT ${EDGESHADE_GENERATED_DIR}/shaders_es2.hpp
  COMMAND ${CMAKE_COMMAND} -DSHADER_DIR=${EDGESHADE_SHADER_DIR}
    -DOUTPUT=${EDGESHADE_GENERATED_DIR}/shaders_es2.hpp
    -DLEFT_OUT=${EDGESHADE_SHADERS_LEFT_OUT}
    -P ${PROJECT_SOURCE_DIR}/cmake/embed_shaders_script.cmake
  DEPENDS ${EDGESHADE_SHADER_FILES} ${PROJECT_SOURCE_DIR}/cmake/embed_shaders_script.cmake
    ${PROJECT_SOURCE_DIR}/cmake/shader_text.cmake
  COMMENT "Embedding shaders"
  VERBATIM)
add_custom_target(edgeshade_shader_header DEPENDS ${EDGESHADE_GENERATED_DIR}/shaders_es2.hpp)
