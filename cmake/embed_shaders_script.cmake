# Run by EmbedShaders.cmake: -DSHADER_DIR=... -DOUTPUT=... -DLEFT_OUT=... -P this file. LEFT_OUT:
# comma-separated files that are not embedded.
include(${CMAKE_CURRENT_LIST_DIR}/shader_text.cmake)
string(REPLACE "," ";" LEFT_OUT "${LEFT_OUT}")

file(GLOB_RECURSE stages ${SHADER_DIR}/*.vert ${SHADER_DIR}/*.frag ${SHADER_DIR}/host/*.glsl)
list(SORT stages)
set(header "// Generated from shaders_es2/. Do not edit.\n#pragma once\n\n")
string(APPEND header "namespace edgeshade::shaders {\n\n")
foreach(stage IN LISTS stages)
  get_filename_component(name ${stage} NAME)
  file(RELATIVE_PATH path ${SHADER_DIR} ${stage})
  if(path IN_LIST LEFT_OUT)
    continue()
  endif()
  string(REPLACE "." "_" identifier ${name})
  read_with_includes(${stage} text)
  if(NOT stage MATCHES "/host/") # hosts may read this text
    without_comments("${text}" text)
  endif()
  string(APPEND header "inline constexpr char ${identifier}[] = R\"glsl(${text})glsl\";\n\n")
endforeach()
string(APPEND header "} // namespace edgeshade::shaders\n")
file(WRITE ${OUTPUT} "${header}")
