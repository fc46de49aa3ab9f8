# Compiler settings shared by every target, and the libraries that the engine stands on.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
elseif(CMAKE_BUILD_TYPE STREQUAL "RelWithDebInfo")
  set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1")
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Relative paths and no directory hash: a fresh clone reuses what another checkout compiled. Precompiled headers are looked up
  # by what is in them, which ccache wants to be told.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros
      ${CCACHE_PROGRAM})
endif()

set(TYNDALL_SANITIZE "" CACHE STRING "Sanitizers for -fsanitize=, comma separated; empty for none")

add_library(tyndall_options INTERFACE)
target_compile_options(tyndall_options INTERFACE -Wall -Wextra -Wconversion -Werror -fno-gnu-unique
  -fPIC  # programs too, which else have -fPIE and cannot share precompiled headers
  -Wno-missing-field-initializers  # members left out of an aggregate have their defaults: that is their point
 )
target_compile_definitions(tyndall_options INTERFACE GLM_FORCE_XYZW_ONLY= GLM_ENABLE_EXPERIMENTAL)
target_include_directories(tyndall_options INTERFACE ${CMAKE_SOURCE_DIR}/engine)
if(TYNDALL_SANITIZE)
  target_compile_options(tyndall_options INTERFACE -fsanitize=${TYNDALL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(tyndall_options INTERFACE -fsanitize=${TYNDALL_SANITIZE})
endif()

list(APPEND CMAKE_MODULE_PATH /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB)
set(OpenColorIO_DIR /usr/share/cmake CACHE PATH "Debian keeps OpenColorIO's CMake package here")
find_package(PkgConfig REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(TBB REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenMesh REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(OpenColorIO REQUIRED)
# Debian's package computes /include; the headers are where every compiler looks.
set_target_properties(OpenColorIO::OpenColorIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "")
find_package(OpenImageIO REQUIRED)
# Debian's OpenImageIO names the headers of an OpenCV that it does not need and that may not be there.
get_target_property(OIIO_INCLUDES OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(FILTER OIIO_INCLUDES EXCLUDE REGEX "opencv")
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${OIIO_INCLUDES}")
find_package(OpenEXR REQUIRED)
find_package(Imath REQUIRED)
find_package(embree 3 REQUIRED)
find_package(glfw3 REQUIRED)
pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(EGL REQUIRED IMPORTED_TARGET egl)

# OpenSubdiv's own CMake package names static libraries that Debian does not ship.
find_library(OSD_CPU_LIBRARY osdCPU REQUIRED)
find_path(OSD_INCLUDE_DIR opensubdiv/version.h REQUIRED)
add_library(tyndall_osd INTERFACE)
target_link_libraries(tyndall_osd INTERFACE ${OSD_CPU_LIBRARY})
target_include_directories(tyndall_osd SYSTEM INTERFACE ${OSD_INCLUDE_DIR})

# OpenVDB's own CMake module asks for Boost libraries that only its optional parts use.
find_library(OPENVDB_LIBRARY openvdb REQUIRED)
find_path(OPENVDB_INCLUDE_DIR openvdb/openvdb.h REQUIRED)
add_library(tyndall_openvdb INTERFACE)
target_link_libraries(tyndall_openvdb INTERFACE ${OPENVDB_LIBRARY} TBB::tbb)
target_include_directories(tyndall_openvdb SYSTEM INTERFACE ${OPENVDB_INCLUDE_DIR})
