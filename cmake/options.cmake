# Warnings, sanitizers and the compiler cache, for our own targets only.
find_program(CCACHE ccache)
if(CCACHE)
    # Without these ccache would pass over every source that has precompiled headers.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

# The folders' libraries become part of a shared one. None of its functions is replaced from outside, so the compiler may
# inline them as in a program.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_library(deadpoint_options INTERFACE)
target_compile_options(deadpoint_options INTERFACE -fno-semantic-interposition)
target_compile_options(deadpoint_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion)
# From version 13 on GCC says of moved strings and of optional values that are made in place what is not so.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    target_compile_options(deadpoint_options INTERFACE -Wno-array-bounds -Wno-maybe-uninitialized)
endif()
# In one unit with other sources, a local name may be that of something global in another of them.
target_compile_options(deadpoint_options INTERFACE $<IF:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,-Wshadow=local,-Wshadow>)
# At each final link: a shared library shows its public functions only, a module of Python its entry, a program keeps Eigen's to
# itself.
set(type $<TARGET_PROPERTY:TYPE>)
target_link_options(deadpoint_options INTERFACE
    -Wl,--version-script=${CMAKE_CURRENT_LIST_DIR}/$<IF:$<STREQUAL:${type},SHARED_LIBRARY>,public,$<IF:$<STREQUAL:${type},MODULE_LIBRARY>,python,own-eigen>>.map)
if(DEADPOINT_WERROR)
    target_compile_options(deadpoint_options INTERFACE -Werror)
endif()
if(DEADPOINT_SANITIZE)
    target_compile_options(deadpoint_options INTERFACE -fsanitize=${DEADPOINT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
    target_compile_definitions(deadpoint_options INTERFACE _GLIBCXX_ASSERTIONS)
    add_library(deadpoint_keep_libraries OBJECT ${CMAKE_CURRENT_LIST_DIR}/keep_libraries.c)
    target_link_options(deadpoint_options INTERFACE -fsanitize=${DEADPOINT_SANITIZE})
    target_link_libraries(deadpoint_options INTERFACE $<TARGET_OBJECTS:deadpoint_keep_libraries>)
endif()
if(DEADPOINT_COVERAGE)
    # A child process ends by _exit(), which by itself would leave its counts unwritten.
    add_library(deadpoint_keep_counts STATIC ${CMAKE_CURRENT_LIST_DIR}/keep_counts.c)
    target_compile_options(deadpoint_options INTERFACE --coverage -fprofile-update=atomic)
    target_link_options(deadpoint_options INTERFACE --coverage -Wl,--wrap=_exit)
    target_link_libraries(deadpoint_options INTERFACE deadpoint_keep_counts)
endif()

if(DEADPOINT_FUZZ)
    target_compile_options(deadpoint_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow
        -fno-sanitize-recover=undefined,float-cast-overflow -fno-omit-frame-pointer)
    target_link_options(deadpoint_options INTERFACE -fsanitize=address,undefined)
endif()

# deadpoint_folder(NAME DEPENDS target...): the library of one folder below src/deadpoint, from all sources in and below it.
function(deadpoint_folder name)
    cmake_parse_arguments(ARG "" "PATH" "DEPENDS;PRIVATE" ${ARGN})
    if(NOT ARG_PATH)
        set(ARG_PATH ${name})
    endif()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_PATH}/*.cpp)
    if(sources)
        add_library(deadpoint_${name} STATIC ${sources})
        target_include_directories(deadpoint_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
        target_link_libraries(deadpoint_${name} PUBLIC ${ARG_DEPENDS} PRIVATE deadpoint_options ${ARG_PRIVATE})
    else()
        add_library(deadpoint_${name} INTERFACE)
        target_include_directories(deadpoint_${name} INTERFACE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
        target_link_libraries(deadpoint_${name} INTERFACE ${ARG_DEPENDS})
    endif()
endfunction()
