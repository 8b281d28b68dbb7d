# The OpenGL loader. Generated at configure time from the specification in python3-glad. With --reproducible, glad does
# not ask the network for a newer specification.
set(glad_folder ${PROJECT_BINARY_DIR}/generated/glad)
if(NOT EXISTS ${glad_folder}/src/gl.c)
  find_program(RELIEF_GLAD glad PATHS /usr/bin NO_DEFAULT_PATH)
  find_program(RELIEF_GLAD glad)
  set(generator ${RELIEF_GLAD})
  if(NOT RELIEF_GLAD)
    # Homebrew has no package of it. It is a program in Python, with two libraries.
    include(framework/cmake/fetch.cmake)
    find_package(Python3 3.10 REQUIRED)
    relief_fetch(glad p/python-glad/python-glad_2.0.2.orig.tar.gz
      0326d59b1ccf8ccae1fface5bfb71bec1bb41fbe2341e722b31f6acac3068aeb)
    relief_fetch(jinja2 j/jinja2/jinja2_3.1.2.orig.tar.gz
      31351a702a408a9e7595a8fc6150fc3f43bb6bf7e319770cbc0db9df9437e852)
    relief_fetch(markupsafe m/markupsafe/markupsafe_2.1.2.orig.tar.gz
      abcabc8c2b26036d62d4c746381a6f7cf60aafcc653198ad678306986b09450d)
    set(generator ${CMAKE_COMMAND} -E env
      PYTHONPATH=${glad_SOURCE_DIR}:${jinja2_SOURCE_DIR}/src:${markupsafe_SOURCE_DIR}/src ${Python3_EXECUTABLE} -m glad)
  endif()
  execute_process(
    COMMAND ${generator} --api gl:core=4.1 --reproducible --quiet --out-path ${glad_folder}
      --extensions GL_KHR_debug,GL_EXT_texture_filter_anisotropic,GL_ARB_conservative_depth,GL_ARB_pipeline_statistics_query
      c
    RESULT_VARIABLE glad_failed OUTPUT_QUIET ERROR_VARIABLE glad_errors)
  if(glad_failed)
    file(REMOVE_RECURSE ${glad_folder})
    message(FATAL_ERROR "glad could not generate the OpenGL loader: ${glad_errors}")
  endif()
endif()
add_library(relief_glad OBJECT ${glad_folder}/src/gl.c)
target_include_directories(relief_glad SYSTEM PUBLIC ${glad_folder}/include)
set_target_properties(relief_glad PROPERTIES POSITION_INDEPENDENT_CODE ON)
