# The tests, where they are: a student's course has none.
enable_testing()
add_subdirectory(${CMAKE_CURRENT_LIST_DIR})
