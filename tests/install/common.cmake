# For the scripts of this folder: a scratch folder, and commands that must succeed.
string(RANDOM LENGTH 8 suffix)
set(scratch ${BUILD}/install-test-${suffix})
file(MAKE_DIRECTORY ${scratch})

# run(COMMAND...): its output is in `output`; a failure ends the test.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE errors)
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        fail("${command} ended with ${result}:\n${text}\n${errors}")
    endif()
    set(output "${text}" PARENT_SCOPE)
endfunction()

function(fail text)
    file(REMOVE_RECURSE ${scratch})
    message(FATAL_ERROR "${text}")
endfunction()

function(require_match text pattern)
    if(NOT text MATCHES "${pattern}")
        fail("'${pattern}' is not in:\n${text}")
    endif()
endfunction()

function(refuse_match text pattern)
    if(text MATCHES "${pattern}")
        fail("'${CMAKE_MATCH_0}' is in:\n${text}")
    endif()
endfunction()
