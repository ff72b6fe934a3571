# deadpoint_embed(TARGET HEADER NAMESPACE function=file...): compiles text files into the program. Each becomes a
# function `std::string_view function()` of NAMESPACE, declared in HEADER; the build notices when a file changes.
function(deadpoint_embed target header namespace)
    set(body "")
    foreach(entry IN LISTS ARGN)
        string(REGEX MATCH "^([^=]+)=(.+)$" matched "${entry}")
        set(function ${CMAKE_MATCH_1})
        set(file ${PROJECT_SOURCE_DIR}/${CMAKE_MATCH_2})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} text)
        string(APPEND body "std::string_view ${function}()\n{\n    return R\"deadpoint(${text})deadpoint\";\n}\n\n")
    endforeach()
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${target}_embedded.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT
        "#include \"${header}\"\n\nnamespace ${namespace} {\n\n@body@}  // namespace ${namespace}\n" @ONLY)
    # By itself, so that a test may link other texts in its place.
    set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    target_sources(${target} PRIVATE ${source})
endfunction()
