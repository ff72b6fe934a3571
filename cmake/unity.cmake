# deadpoint_unity(TARGET...): with DEADPOINT_UNITY, compiles several sources of a target as one (CMake's unity build), since nearly
# all time goes into the headers that they share. Names in anonymous namespaces then have to differ within a target.
# Sources still include what they use: the presets debug, thread and fuzz build without this.
function(deadpoint_unity)
    if(DEADPOINT_UNITY)
        set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    endif()
endfunction()
