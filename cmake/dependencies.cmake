# Libraries of Debian; scripts/install-dependencies installs them, docs/dependencies.md says why each is there.
if(POLICY CMP0167)
    cmake_policy(SET CMP0167 NEW)  # Boost brings its own package file
endif()
find_package(fmt REQUIRED)
find_package(ZLIB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(spdlog REQUIRED)
find_package(doctest QUIET)
find_package(Boost REQUIRED)

# A library without a package file for CMake, as a target.
function(deadpoint_library target library header)
    find_library(${target}_LIBRARY ${library} REQUIRED)
    find_path(${target}_INCLUDE ${header} REQUIRED)
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${${target}_LIBRARY})
    target_include_directories(${target} SYSTEM INTERFACE ${${target}_INCLUDE})
endfunction()

deadpoint_library(udunits2 udunits2 udunits2.h)
deadpoint_library(muparser muparser muParser.h)
deadpoint_library(seccomp seccomp seccomp.h)
deadpoint_library(nlopt nlopt nlopt.hpp)
deadpoint_library(mumps dmumps dmumps_c.h)
deadpoint_library(metis metis metis.h)
deadpoint_library(gmsh gmsh gmsh.h)

find_path(TOMLPLUSPLUS_INCLUDE toml++/toml.h REQUIRED)
add_library(tomlplusplus INTERFACE)
target_include_directories(tomlplusplus SYSTEM INTERFACE ${TOMLPLUSPLUS_INCLUDE})

# Open CASCADE, which Gmsh needs too. Its own package file asks for the parts with windows as well.
find_path(OPENCASCADE_INCLUDE Standard.hxx PATH_SUFFIXES opencascade REQUIRED)
add_library(opencascade INTERFACE)
target_include_directories(opencascade SYSTEM INTERFACE ${OPENCASCADE_INCLUDE})
# Since version 7.8 one toolkit reads STEP, five did before.
find_library(TKDESTEP_LIBRARY TKDESTEP)
set(read_step TKXDESTEP TKSTEP TKSTEPAttr TKSTEP209 TKSTEPBase)
if(TKDESTEP_LIBRARY)
    set(read_step TKDESTEP)
endif()
foreach(toolkit IN LISTS read_step ITEMS TKXCAF TKLCAF TKCAF TKCDF TKXSBase TKBO TKShHealing TKMesh TKPrim TKTopAlgo TKGeomAlgo TKBRep
    TKG3d TKGeomBase TKMath TKernel)
    find_library(${toolkit}_LIBRARY ${toolkit} REQUIRED)
    target_link_libraries(opencascade INTERFACE ${${toolkit}_LIBRARY})
endforeach()

# PETSc with MPI, the dense algebra beneath both, and ML, if PETSc's preconditioner makes its hierarchy by it (fem/conduction/stage_matrix).
# The package file's own flags would set warnings and optimisation.
find_package(PkgConfig REQUIRED)
pkg_check_modules(PETSC REQUIRED PETSc)
find_package(MPI REQUIRED COMPONENTS C)
find_package(LAPACK REQUIRED)
add_library(petsc INTERFACE)
target_link_libraries(petsc INTERFACE ${PETSC_LINK_LIBRARIES} MPI::MPI_C LAPACK::LAPACK)
target_include_directories(petsc SYSTEM INTERFACE ${PETSC_INCLUDE_DIRS})
file(STRINGS ${PETSC_INCLUDEDIR}/petscconf.h has_ml REGEX "define PETSC_HAVE_ML ")
if(has_ml)
    find_library(ML_LIBRARY trilinos_ml REQUIRED)
    find_path(ML_INCLUDE ml_utils.h PATH_SUFFIXES trilinos REQUIRED)
    target_link_libraries(petsc INTERFACE ${ML_LIBRARY})
    target_include_directories(petsc SYSTEM INTERFACE ${ML_INCLUDE})
endif()
