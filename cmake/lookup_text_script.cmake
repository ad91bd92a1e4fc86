# Writes the functions that hosts' shaders call as a JavaScript module; run by web/CMakeLists.txt:
# -DSHADER_DIR=... -DOUTPUT=... -P this file.
include(${CMAKE_CURRENT_LIST_DIR}/shader_text.cmake)

set(LEFT_OUT primitive_map_tables.glsl primitive_map_places.glsl) # the viewer's own
read_with_includes(${SHADER_DIR}/host/lookup.glsl text)
string(REGEX REPLACE " *//[^\n]*" "" text "${text}")
string(REGEX REPLACE "\n[\n ]+" "\n" text "${text}")
file(WRITE ${OUTPUT} "// Generated from shaders_es2/host/lookup.glsl.\nexport const text = `${text}`;\n")
