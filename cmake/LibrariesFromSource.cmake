# Draco, meshoptimizer and ERFA, for pages GLU's tessellator too, from source, without fused multiply-adds: so the floats that they
# decode and compute are the same on every processor, and packed files too (docs/platforms.md).
include(FetchContent)
add_compile_options(-ffp-contract=off)
set(own_unity_build ${CMAKE_UNITY_BUILD})
set(CMAKE_UNITY_BUILD OFF)

# Debian's source packages if cmake/sources.sh has fetched them, else the same versions from
# upstream.
foreach(library draco meshoptimizer erfa glu)
  string(TOUPPER ${library} upper)
  if(EXISTS ${PROJECT_SOURCE_DIR}/build/sources/${library})
    set(FETCHCONTENT_SOURCE_DIR_${upper} ${PROJECT_SOURCE_DIR}/build/sources/${library})
  endif()
endforeach()
FetchContent_Declare(draco GIT_REPOSITORY https://github.com/google/draco GIT_TAG 1.5.5
  GIT_SUBMODULES "")
FetchContent_Declare(meshoptimizer GIT_REPOSITORY https://github.com/zeux/meshoptimizer
  GIT_TAG v0.18)
FetchContent_Declare(erfa GIT_REPOSITORY https://github.com/liberfa/erfa GIT_TAG v2.0.0)
FetchContent_Declare(glu GIT_REPOSITORY https://gitlab.freedesktop.org/mesa/glu.git GIT_TAG glu-9.0.2)

FetchContent_GetProperties(draco)
if(NOT draco_POPULATED)
  FetchContent_Populate(draco)
  if(EMSCRIPTEN)
    set(DRACO_WASM ON CACHE BOOL "" FORCE)
    set(DRACO_JS_GLUE OFF CACHE BOOL "" FORCE)
    get_filename_component(emscripten_folder ${CMAKE_CXX_COMPILER} REALPATH)
    get_filename_component(emscripten_folder ${emscripten_folder} DIRECTORY)
    set(ENV{EMSCRIPTEN} ${emscripten_folder}) # Draco's CMake files read it
  endif()
  add_subdirectory(${draco_SOURCE_DIR} ${draco_BINARY_DIR} EXCLUDE_FROM_ALL)
  target_include_directories(draco_static SYSTEM INTERFACE
    $<BUILD_INTERFACE:${draco_SOURCE_DIR}/src> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}>)
  if(EMSCRIPTEN)
    # Only the decoding sources: the linker would throw the rest away.
    get_target_property(draco_parts draco_static SOURCES)
    list(FILTER draco_parts EXCLUDE
      REGEX "_(enc|encode|enc_config|options|io|animation|animation_dec)>")
    set_property(TARGET draco_static PROPERTY SOURCES ${draco_parts})
  endif()
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

FetchContent_GetProperties(erfa)
if(NOT erfa_POPULATED)
  FetchContent_Populate(erfa)
  # The files among its 250 that src/sun/ephemeris.cpp needs: Earth and Moon, precession and
  # nutation (IAU 2000B), sidereal time, leap seconds, the ellipsoid.
  set(parts anp anpm bi00 bp00 cal2jd cp cr dat ee00 ee00b eect00 eform era00 erfadatextra fad03
    fae03 faf03 fal03 falp03 faom03 fapa03 fave03 gd2gc gd2gce gmst00 gst00b ir moon98 numat nut00b
    obl06 obl80 pfw06 plan94 pn00 pn00b pnm00b pr00 rx rxp rxpv rxr ry rz s2pv zp)
  list(TRANSFORM parts PREPEND ${erfa_SOURCE_DIR}/src/)
  list(TRANSFORM parts APPEND .c)
  add_library(erfa_part STATIC EXCLUDE_FROM_ALL ${parts})
  target_include_directories(erfa_part SYSTEM PUBLIC ${erfa_SOURCE_DIR}/src)
  if(EMSCRIPTEN)
    target_compile_options(erfa_part PRIVATE -Oz) # a page's size counts more than speed here
  endif()
  add_library(erfa::erfa ALIAS erfa_part)
endif()

# Native builds link the system's libGLU.a.
FetchContent_GetProperties(glu)
if(EMSCRIPTEN AND NOT glu_POPULATED)
  FetchContent_Populate(glu)
  set(parts dict geom memalloc mesh normal priorityq render sweep tess tessmono)
  list(TRANSFORM parts PREPEND ${glu_SOURCE_DIR}/src/libtess/)
  list(TRANSFORM parts APPEND .c)
  add_library(glu_tessellator STATIC EXCLUDE_FROM_ALL ${parts})
  target_include_directories(glu_tessellator SYSTEM PUBLIC ${glu_SOURCE_DIR}/include
    PRIVATE ${glu_SOURCE_DIR}/src/include)
  target_compile_options(glu_tessellator PRIVATE -Oz -w)
endif()
set(CMAKE_UNITY_BUILD ${own_unity_build})
