# Libraries of the core, all from Debian by package name; reasons in docs/dependencies.md.
find_package(CGAL REQUIRED)           # libcgal-dev: Delaunay, exact predicates (src/tetra only)
find_package(nlohmann_json REQUIRED)  # nlohmann-json3-dev: the report (src/io only)
find_package(nanoflann REQUIRED)      # libnanoflann-dev: nearest samples (src/cloud only)
find_package(Eigen3 REQUIRED CONFIG)  # libeigen3-dev: small least squares (src/feature only)

add_library(arris_dependencies INTERFACE)
# SYSTEM: their headers are not ours to keep free of warnings.
foreach(library CGAL::CGAL nlohmann_json::nlohmann_json nanoflann::nanoflann Eigen3::Eigen)
  target_link_libraries(arris_dependencies INTERFACE ${library})
  get_target_property(includes ${library} INTERFACE_INCLUDE_DIRECTORIES)
  if(includes)
    target_include_directories(arris_dependencies SYSTEM INTERFACE ${includes})
  endif()
endforeach()
