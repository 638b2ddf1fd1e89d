# Every third-party package, found once. All come from Debian 12 (scripts/deps.sh); nothing is fetched.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(tl-expected REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
pkg_check_modules(IPOPT REQUIRED IMPORTED_TARGET ipopt)

# MUMPS ships no CMake or pkg-config file. The sequential build is the one Ipopt links.
find_path(MUMPS_INCLUDE_DIR dmumps_c.h REQUIRED)
find_library(MUMPS_LIBRARY dmumps_seq REQUIRED)
add_library(mumps_seq INTERFACE)
target_include_directories(mumps_seq SYSTEM INTERFACE ${MUMPS_INCLUDE_DIR})
target_link_libraries(mumps_seq INTERFACE ${MUMPS_LIBRARY})

# OpenMesh without its imported target's C++11 baggage: only OpenMeshCore, as a system include.
find_path(OPENMESH_INCLUDE_DIR OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh REQUIRED)
find_library(OPENMESH_CORE_LIBRARY OpenMeshCore REQUIRED)
add_library(openmesh_core INTERFACE)
target_include_directories(openmesh_core SYSTEM INTERFACE ${OPENMESH_INCLUDE_DIR})
target_link_libraries(openmesh_core INTERFACE ${OPENMESH_CORE_LIBRARY})

# Of CGAL only the exact predicates of its kernel (LGPL): headers alone, on Boost's multiprecision numbers instead
# of GMP and MPFR. CGAL_LICENSE_ERROR makes including one of its GPL packages a compile error. Its interval arithmetic
# switches the rounding mode, which the compiler has to know.
find_package(Boost 1.74 REQUIRED)
find_path(CGAL_INCLUDE_DIR CGAL/Exact_predicates_inexact_constructions_kernel.h REQUIRED)
add_library(cgal_kernel INTERFACE)
target_include_directories(cgal_kernel SYSTEM INTERFACE ${CGAL_INCLUDE_DIR})
target_link_libraries(cgal_kernel INTERFACE Boost::headers)
target_compile_definitions(cgal_kernel INTERFACE CGAL_DISABLE_GMP CGAL_LICENSE_ERROR)
target_compile_options(cgal_kernel INTERFACE -frounding-math)

# Writers of the workshop's files, and the readers of its certificate, none of which is one of the writers.
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(PUGIXML REQUIRED IMPORTED_TARGET pugixml)
pkg_check_modules(LIB3MF REQUIRED IMPORTED_TARGET lib3MF)
find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h REQUIRED)
pkg_check_modules(DIME REQUIRED IMPORTED_TARGET dime)
pkg_check_modules(LIBXML2 REQUIRED IMPORTED_TARGET libxml-2.0)
pkg_check_modules(QPDF REQUIRED IMPORTED_TARGET libqpdf)
find_library(TINYOBJLOADER_DOUBLE_LIBRARY tinyobjloader_double REQUIRED)
pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp)
pkg_check_modules(MINIZIP REQUIRED IMPORTED_TARGET minizip)

# Nesting: headers, on Clipper and NLopt.
find_path(LIBNEST2D_INCLUDE_DIR libnest2d/libnest2d.hpp REQUIRED)
pkg_check_modules(CLIPPER REQUIRED IMPORTED_TARGET polyclipping)
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)

# Rendering without a display (EGL) and in the window.
pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(FREETYPE REQUIRED IMPORTED_TARGET freetype2)
find_package(glm REQUIRED)
find_path(STB_INCLUDE_DIR stb_image_write.h PATH_SUFFIXES stb REQUIRED)

if(PLANEWRIGHT_WINDOW)
  # One call for all four: libimgui.a must stand before freetype on the link line.
  pkg_check_modules(WINDOW REQUIRED IMPORTED_TARGET imgui freetype2 glfw3 epoxy)
endif()
if(PLANEWRIGHT_TESTS)
  find_package(GTest REQUIRED)
endif()
