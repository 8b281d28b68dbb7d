# Two libraries of which Debian has packages and other systems do not, or with other folders and versions. What is not
# found is fetched in Debian's version.
include(framework/cmake/fetch.cmake)
if(NOT imgui_FOUND)
  include(framework/cmake/fetched_imgui.cmake)
  target_link_libraries(relief_imgui PUBLIC glfw)
endif()
if(NOT RELIEF_MUSTACHE)
  relief_fetch(mustache libk/libkainjow-mustache/libkainjow-mustache_4.1+ds.orig.tar.xz
    da0ed0c7d9842cf9f68f9f7e3f58e456efc5a7d6c05cb8786f98ed3979e56685)
  file(COPY ${mustache_SOURCE_DIR}/mustache.hpp DESTINATION ${PROJECT_BINARY_DIR}/generated/mustache/kainjow)
  include_directories(SYSTEM ${PROJECT_BINARY_DIR}/generated/mustache)
endif()
