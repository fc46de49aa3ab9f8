# tyndall_shared_headers()
#
# Headers of libraries that nearly every source reads, compiled once for the engine and its libraries, and once for the tests: a
# third of a build's time was theirs. A source still names all that it uses: clang-tidy reads it without these. Few and small ones
# only, since reading them back takes time too: JSON in them costs more than it saves.
function(tyndall_shared_headers)
  set(headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <string> <string_view> <vector>
    <glm/geometric.hpp> <glm/mat4x4.hpp> <glm/vec2.hpp> <glm/vec3.hpp> <glm/vec4.hpp> <fmt/format.h>)
  add_library(shared_headers OBJECT ${CMAKE_SOURCE_DIR}/tools/cmake/shared_headers.cpp)
  target_link_libraries(shared_headers PRIVATE tyndall_options glm::glm fmt::fmt)
  target_precompile_headers(shared_headers PRIVATE ${headers})
  if(TYNDALL_TESTS)
    add_library(shared_test_headers OBJECT ${CMAKE_SOURCE_DIR}/tools/cmake/shared_headers.cpp)
    target_link_libraries(shared_test_headers PRIVATE tyndall_options glm::glm fmt::fmt GTest::gtest)
    target_precompile_headers(shared_test_headers PRIVATE ${headers} <gtest/gtest.h>)
  endif()
endfunction()

# tyndall_floor(NAME HEADERS ... SOURCES ... [LINK ...] [SHARED_LINK ...])
#
# One floor of the engine (docs/architecture.md): compiled on its own, linked into libtyndall. LINK is what only the floor's
# sources include; SHARED_LINK is what its public headers include. HEADERS are the public ones: the target
# `check_headers` compiles each alone.
set(TYNDALL_HEADER_STUBS "" CACHE INTERNAL "")
function(tyndall_floor NAME)
  cmake_parse_arguments(FLOOR "" "" "HEADERS;SOURCES;LINK;SHARED_LINK" ${ARGN})
  add_library(tyndall_${NAME} OBJECT ${FLOOR_SOURCES} ${FLOOR_HEADERS})
  target_link_libraries(tyndall_${NAME} PRIVATE tyndall_options ${FLOOR_LINK} PUBLIC glm::glm fmt::fmt ${FLOOR_SHARED_LINK})
  target_precompile_headers(tyndall_${NAME} REUSE_FROM shared_headers)
  target_link_libraries(tyndall PRIVATE tyndall_${NAME} PUBLIC ${FLOOR_SHARED_LINK})
  set(stubs ${TYNDALL_HEADER_STUBS})
  foreach(header ${FLOOR_HEADERS})
    set(stub ${CMAKE_BINARY_DIR}/header_stubs/${NAME}_${header}.cpp)
    file(GENERATE OUTPUT ${stub} CONTENT "#include \"${NAME}/${header}\"\n#include \"${NAME}/${header}\"\n")
    list(APPEND stubs ${stub})
  endforeach()
  set(TYNDALL_HEADER_STUBS ${stubs} CACHE INTERNAL "")
endfunction()

# tyndall_module_library(TARGET NAME FOLDER SOURCES ... [LINK ...])
#
# A hot-loadable module NAME as FOLDER/NAME.so. Hidden visibility and no unique symbols, so that dlclose really unloads it.
function(tyndall_module_library TARGET NAME FOLDER)
  cmake_parse_arguments(MODULE "" "" "SOURCES;LINK" ${ARGN})
  add_library(${TARGET} MODULE ${MODULE_SOURCES})
  set_target_properties(${TARGET} PROPERTIES
    PREFIX "" OUTPUT_NAME ${NAME} LIBRARY_OUTPUT_DIRECTORY ${FOLDER}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(${TARGET} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_compile_definitions(${TARGET} PRIVATE TYNDALL_MODULE_NAME="${NAME}")
  target_link_libraries(${TARGET} PRIVATE tyndall_options tyndall tyndall_abi ${MODULE_LINK})
  target_precompile_headers(${TARGET} REUSE_FROM module_headers)
endfunction()

# tyndall_module(NAME SOURCES ... [LINK ...])
#
# A module of the program: build/<preset>/modules/NAME.so.
function(tyndall_module NAME)
  tyndall_module_library(module_${NAME} ${NAME} ${CMAKE_BINARY_DIR}/modules ${ARGN})
  add_dependencies(play module_${NAME})
endfunction()

# tyndall_test(NAME [SANITIZED] SOURCES ... [LINK ...] [MODULES ...])
#
# A GoogleTest program: build/<preset>/bin/NAME, one ctest entry, run from the project's root. SANITIZED: tools/test runs it under
# AddressSanitizer too. MODULES are built first.
function(tyndall_test NAME)
  cmake_parse_arguments(TEST "SANITIZED" "" "SOURCES;LINK;MODULES" ${ARGN})
  add_executable(${NAME} ${TEST_SOURCES})
  target_link_libraries(${NAME} PRIVATE tyndall_options tyndall GTest::gtest_main ${TEST_LINK})
  target_precompile_headers(${NAME} REUSE_FROM shared_test_headers)
  add_test(NAME ${NAME} COMMAND ${NAME} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  foreach(module ${TEST_MODULES})
    add_dependencies(${NAME} module_${module})
  endforeach()
  if(TEST_SANITIZED)
    set_tests_properties(${NAME} PROPERTIES LABELS sanitized)
    add_dependencies(sanitized ${NAME})
  endif()
endfunction()

# tyndall_captures(NAME FILE...)
#
# Capture files as tests: ctest runs `tyndall capture` on them, which fails when an expectation does not hold.
function(tyndall_captures NAME)
  if(NOT TYNDALL_TESTS)
    return()
  endif()
  foreach(file ${ARGN})
    get_filename_component(stem ${file} NAME_WE)
    add_test(NAME capture_${NAME}_${stem}
      COMMAND tyndall_program capture ${CMAKE_CURRENT_SOURCE_DIR}/${file} --out ${CMAKE_BINARY_DIR}/captures
      WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  endforeach()
endfunction()
