# The OpenGL loader. Generated at configure time from the specification in python3-glad. With --reproducible, glad does
# not ask the network for a newer specification.
set(glad_folder ${PROJECT_BINARY_DIR}/generated/glad)
if(NOT EXISTS ${glad_folder}/src/gl.c)
  find_program(RELIEF_GLAD glad PATHS /usr/bin NO_DEFAULT_PATH)
  find_program(RELIEF_GLAD glad REQUIRED)
  execute_process(
    COMMAND ${RELIEF_GLAD} --api gl:core=4.1 --reproducible --quiet --out-path ${glad_folder}
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
