# Run by cpack before it makes each package: arranges the staged files as Debian's policy wants them.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
find_program(gzip gzip REQUIRED)

function(compress file)
  execute_process(COMMAND ${gzip} -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The folder of a component: its files lie in usr/, as in the package.
function(arrange folder package)
  set(documents ${folder}/usr/share/doc/${package})
  file(REMOVE ${documents}/LICENSE ${documents}/LICENSE.glu) # copyright holds them
  file(MAKE_DIRECTORY ${documents})
  file(COPY_FILE ${CPACK_EDGESHADE_COPYRIGHT} ${documents}/copyright)
  file(REMOVE ${documents}/CHANGELOG.md)
  file(COPY_FILE ${CPACK_EDGESHADE_SOURCE_DIR}/CHANGELOG.md ${documents}/changelog)
  file(COPY_FILE ${CPACK_EDGESHADE_CHANGELOG} ${documents}/changelog.Debian)
  file(GLOB texts ${documents}/changelog* ${folder}/usr/share/man/man1/*.1)
  foreach(text IN LISTS texts)
    compress(${text})
  endforeach()
  file(GLOB archives ${folder}/usr/lib/*.a ${folder}/usr/lib/*/*.a)
  foreach(archive IN LISTS archives)
    execute_process(COMMAND ${CPACK_EDGESHADE_STRIP} --strip-debug --remove-section=.comment
      --remove-section=.note --enable-deterministic-archives ${archive} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  file(CHMOD_RECURSE ${folder}/usr/share DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE FILE_PERMISSIONS OWNER_READ OWNER_WRITE
    GROUP_READ WORLD_READ)
endfunction()

arrange(${CPACK_TEMPORARY_DIRECTORY}/program edgeshade)
arrange(${CPACK_TEMPORARY_DIRECTORY}/development libedgeshade-dev)
