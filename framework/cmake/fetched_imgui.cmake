# The library of the menu. What includes this links GLFW to it.
relief_fetch(imgui i/imgui/imgui_1.86+ds.orig.tar.xz 0dace0e8e57d298eb6e93af12dc19420cb96330832f6495c733b90aeeef11f64)
set(stem ${imgui_SOURCE_DIR}/imgui)
relief_compile(relief_imgui PkgConfig::imgui ${stem}.cpp ${stem}_draw.cpp ${stem}_tables.cpp ${stem}_widgets.cpp
  ${imgui_SOURCE_DIR}/backends/imgui_impl_glfw.cpp ${imgui_SOURCE_DIR}/backends/imgui_impl_opengl3.cpp)
target_include_directories(relief_imgui SYSTEM PUBLIC ${imgui_SOURCE_DIR})
target_include_directories(relief_imgui SYSTEM PRIVATE ${imgui_SOURCE_DIR}/backends)
set(imgui_VERSION 1.86)
