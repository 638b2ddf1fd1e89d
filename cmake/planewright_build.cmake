# Compiler settings shared by every target, and the helper that makes one library per folder.
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

find_program(CCACHE ccache)
if(CCACHE)
  # Precompiled headers and ccache agree only with this.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

add_library(planewright_options INTERFACE)
target_compile_options(planewright_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(PLANEWRIGHT_SANITIZE)
  add_compile_options(-fsanitize=${PLANEWRIGHT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=${PLANEWRIGHT_SANITIZE})
endif()

# planewright_library(NAME SOURCES a.cpp ... [DEPENDS lib ...] [PRIVATE_DEPENDS lib ...])
# One static library per folder of src/, so that an include against the direction of the
# architecture does not link (and tests/architecture_test.cpp says so first).
function(planewright_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PUBLIC ${ARG_DEPENDS} PRIVATE planewright_options ${ARG_PRIVATE_DEPENDS})
endfunction()
