# Adds the tests if they exist. A student's course has none.
enable_testing()
add_subdirectory(${CMAKE_CURRENT_LIST_DIR})
