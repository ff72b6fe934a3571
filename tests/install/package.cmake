# Requirement: the Debian package holds the command, libraries, headers, manual and completions, and names what it needs.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
run(${CMAKE_COMMAND} -E chdir ${BUILD} cpack -G DEB -B ${scratch})
file(GLOB package ${scratch}/deadpoint_*.deb)
if(NOT package)
    fail("cpack made no package")
endif()
run(dpkg-deb --contents ${package})
foreach(path IN ITEMS bin/deadpoint lib/libdeadpoint.so. lib/libdeadpoint_reduced.so. lib/cmake/deadpoint/deadpointConfig.cmake
        include/deadpoint/press.hpp share/man/man1/deadpoint.1 share/bash-completion/completions/deadpoint
        share/zsh/vendor-completions/_deadpoint share/fish/vendor_completions.d/deadpoint.fish
        share/deadpoint/cases/starter/case.toml share/deadpoint/examples/link_deadpoint/drift.cpp)
    require_match("${output}" "/usr/${path}")
endforeach()
refuse_match("${output}" "${SOURCE}|${BUILD}")
run(dpkg-deb --field ${package} Depends)
foreach(library IN ITEMS libc6 libstdc\\+\\+6 libgmsh libdeal.ii libpetsc libopenmpi libfmt libmuparser libudunits2)
    require_match("${output}" "${library}")
endforeach()
run(dpkg-deb --field ${package} Version Architecture Maintainer Description)
require_match("${output}" "bottom dead point")
file(REMOVE_RECURSE ${scratch})
