# A shader's text with its includes, except for files of the list LEFT_OUT.
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

# A shader's text without its comments, which GLSL compilers don't need: C++ compilers need not
# accept strings of more than 65,536 characters, and every page downloads them.
function(without_comments text result)
  string(REGEX REPLACE "[ \t]*//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "\n\n+" "\n" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()
