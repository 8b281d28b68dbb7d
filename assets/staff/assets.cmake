# The program that makes the textures.
file(GLOB asset_sources CONFIGURE_DEPENDS assets/*.cpp assets/staff/*.cpp)
list(REMOVE_ITEM asset_sources ${PROJECT_SOURCE_DIR}/assets/staff/make.cpp)
add_library(relief_asset_sources OBJECT ${asset_sources})
target_link_libraries(relief_asset_sources PUBLIC relief_staff PRIVATE relief_warnings)
add_executable(relief-assets EXCLUDE_FROM_ALL assets/staff/make.cpp)
target_link_libraries(relief-assets PRIVATE relief_asset_sources relief_warnings)
add_dependencies(relief-assets relief_modules)
