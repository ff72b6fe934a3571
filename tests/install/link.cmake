# Requirement: an installed copy can be found, linked and run by a program that knows nothing of our build.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
set(prefix ${scratch}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

# The example, from the installed copy of it.
set(example ${prefix}/share/deadpoint/examples/link_deadpoint)
run(${CMAKE_COMMAND} -S ${example} -B ${scratch}/example -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=-Wall\ -Wextra\ -Werror)
require_match("${output}" "Generating done")
file(STRINGS ${scratch}/example/CMakeCache.txt found REGEX "^deadpoint_DIR")
require_match("${found}" "${prefix}")
run(${CMAKE_COMMAND} --build ${scratch}/example)
run(${scratch}/example/drift ${prefix}/share/deadpoint/cases/starter/case.toml)
require_match("${output}" "gap after 30 min: [-+][0-9]+\\.[0-9]+ um")
run(${scratch}/example/light ${SOURCE}/tests/fuzz/sound/press.rom ${prefix}/share/deadpoint/cases/starter/case.toml "50 rpm")
require_match("${output}" "gap at the end: [-+][0-9]+\\.[0-9]+ um")
require_match("${output}" "operation.speed +[-+][0-9.]+ um per")
run(${prefix}/bin/deadpoint --version)

# Python finds both modules, and the command that belongs to them.
set(python ${CMAKE_COMMAND} -E env PYTHONPATH=${prefix}/lib/python3/dist-packages /usr/bin/python3 -c)
run(${python} "print(len(__import__('deadpoint').load('${prefix}/share/deadpoint/cases/starter/case.toml').mesh(4).parts))")
require_match("${output}" "^14")
run(${python} "from deadpoint import _command as c, load\nprint(c.command())")
require_match("${output}" "^${prefix}/bin/deadpoint")

# A case with a mistake is told by place.
file(WRITE ${scratch}/broken.toml "format = 1\n[machine]\nambient = \"20 kg\"\n")
execute_process(COMMAND ${scratch}/example/drift ${scratch}/broken.toml RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 2)
    fail("a broken case ended with ${result}: ${errors}")
endif()
require_match("${errors}" "line 3: machine.ambient: ")

# The light part needs none of the heavy libraries, not even through others.
run(ldd ${prefix}/lib/libdeadpoint_twin.so)
refuse_match("${output}" "gmsh|deal|petsc|mpi|not found")
# Public functions only; Eigen's above all stay inside (cmake/own-eigen.map).
foreach(library IN ITEMS deadpoint deadpoint_twin)
    run(nm -DC --defined-only ${prefix}/lib/lib${library}.so)
    require_match("${output}" "deadpoint::library_version")
    refuse_match("${output}" "Eigen::|deadpoint::(press|twin|full|report|fem|casefile)::[a-z_]+\\(")
endforeach()
file(REMOVE_RECURSE ${scratch})
