# A shader's text with what it includes, but for files of the list LEFT_OUT.
cmake_policy(VERSION 3.22)
function(read_with_includes path result)
  file(READ ${path} text)
  string(REGEX MATCH "#include \"([^\"]+)\"" line "${text}")
  while(line)
    if(CMAKE_MATCH_1 IN_LIST LEFT_OUT)
      set(included "")
    else()
      read_with_includes(${SHADER_DIR}/${CMAKE_MATCH_1} included)
    endif()
    string(REPLACE "${line}" "${included}" text "${text}")
    string(REGEX MATCH "#include \"([^\"]+)\"" line "${text}")
  endwhile()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# A shader's text without its comments, which GLSL compilers don't need: compilers of C++ must take
# no strings of more than 65,536 characters, and pages download each.
function(without_comments text result)
  string(REGEX REPLACE "[ \t]*//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "\n\n+" "\n" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()
