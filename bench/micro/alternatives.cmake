# Optional (OXTURN_ALTERNATIVES): our overlay and predicates against other libraries.
find_library(GEOS_C geos_c REQUIRED)
find_library(CLIPPER polyclipping REQUIRED)
add_executable(oxturn_alternatives ${CMAKE_CURRENT_LIST_DIR}/alternatives_bench.cpp)
target_link_libraries(oxturn_alternatives PRIVATE oxturn_options oxturn::geometry CGAL::CGAL ${GEOS_C} ${CLIPPER}
                      benchmark::benchmark benchmark::benchmark_main)
