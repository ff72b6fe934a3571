# Where things go: `cmake --install`, and the Debian package by `cpack`.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME deadpoint)

install(TARGETS deadpoint RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS deadpoint_shared deadpoint_twin_shared EXPORT deadpointTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/deadpoint DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/deadpoint)
install(EXPORT deadpointTargets NAMESPACE deadpoint:: DESTINATION ${package})
configure_package_config_file(cmake/deadpointConfig.cmake.in ${PROJECT_BINARY_DIR}/deadpointConfig.cmake
    INSTALL_DESTINATION ${package})
# Before version 1, what compiled against another minor version must be compiled again (docs/library.md).
write_basic_package_version_file(${PROJECT_BINARY_DIR}/deadpointConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/deadpointConfig.cmake ${PROJECT_BINARY_DIR}/deadpointConfigVersion.cmake
    DESTINATION ${package})

set(data ${CMAKE_INSTALL_DATADIR}/deadpoint)
install(DIRECTORY cases DESTINATION ${data})
install(DIRECTORY examples DESTINATION ${data})
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The command writes its own manual and completions, so that they name the options that it has.
set(manual ${PROJECT_BINARY_DIR}/manual)
file(MAKE_DIRECTORY ${manual})
set(manual_files deadpoint.1 deadpoint.bash _deadpoint deadpoint.fish)
list(TRANSFORM manual_files PREPEND ${manual}/)
add_custom_command(OUTPUT ${manual_files} COMMAND deadpoint --write-manual ${manual} DEPENDS deadpoint
    COMMENT "Writing the manual and the completions")
add_custom_target(deadpoint_manual ALL DEPENDS ${manual_files})
install(FILES ${manual}/deadpoint.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${manual}/deadpoint.bash RENAME deadpoint
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${manual}/_deadpoint DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${manual}/deadpoint.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# The documentation as a site, where MkDocs is there with its theme (mkdocs.yml).
find_program(MKDOCS mkdocs)
if(MKDOCS)
    execute_process(COMMAND ${MKDOCS} build --help OUTPUT_VARIABLE themes ERROR_QUIET)
endif()
if("${themes}" MATCHES "material" AND NOT DEADPOINT_SANITIZE AND NOT DEADPOINT_COVERAGE AND NOT DEADPOINT_FUZZ)
    set(mkdocs ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${MKDOCS} build --quiet --config-file ${PROJECT_SOURCE_DIR}/mkdocs.yml)
    set(site ${PROJECT_BINARY_DIR}/docs)
    file(GLOB_RECURSE pages CONFIGURE_DEPENDS docs/*.md docs/images/* cases/*.md scripts/site/*.py scripts/site/theme/*)
    list(APPEND pages README.md CHANGELOG.md CONTRIBUTING.md)
    add_custom_command(OUTPUT ${site}.stamp COMMAND ${mkdocs} --site-dir ${site} COMMAND ${CMAKE_COMMAND} -E touch ${site}.stamp
        DEPENDS ${pages} mkdocs.yml scripts/check_links.py COMMENT "Writing the documentation as a site")
    add_custom_target(docs ALL DEPENDS ${site}.stamp)
    install(DIRECTORY ${site}/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/html OPTIONAL)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME deadpoint)
set(CPACK_PACKAGE_CONTACT "deadpoint <deadpoint@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# Two packages: the command with the libraries, and what Python needs (python/CMakeLists.txt).
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL deadpoint)
set(CPACK_DEBIAN_DEADPOINT_PACKAGE_NAME deadpoint)
if(TARGET deadpoint_reduced_module)
    list(APPEND CPACK_COMPONENTS_ALL python)
    set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${PROJECT_DESCRIPTION}: cases, results and reduced presses in Python")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-deadpoint)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
        "python3 (>= ${DEADPOINT_PYTHON_VERSION}), python3 (<< ${DEADPOINT_PYTHON_NEXT}), python3-numpy")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "deadpoint, python3-matplotlib, python3-pandas")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-xarray, python3-pint, python3-tqdm")
endif()
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Without mpirun the program uses one core; dense kernels take half the time by OpenBLAS.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "openmpi-bin, libopenblas0-serial")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS paraview)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
