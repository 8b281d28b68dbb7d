# The labs for a browser: one WebAssembly module with all labs and their checks. The page around it belongs to the
# staff, who make the site (framework/staff/web).
file(GLOB web_sources CONFIGURE_DEPENDS framework/core/gl/*.cpp framework/core/lab/*.cpp framework/library/kit/*.cpp
  framework/course/manifest/*.cpp framework/course/task/*.cpp framework/course/explain/*.cpp
  framework/course/check/*.cpp framework/course/web/*.cpp)
# Without what needs processes or rewrites shaders: drawing under guard, and `explain`.
list(FILTER web_sources EXCLUDE REGEX "(check/(guarded_drawing|explain|explain_text|watched_shader)|web/web)\\.cpp$")
add_library(relief_framework OBJECT ${web_sources})
target_link_libraries(relief_framework PUBLIC relief_cpu relief_glad
  PRIVATE tomlplusplus::tomlplusplus nlohmann_json::nlohmann_json relief_warnings)
relief_takes_precompiled_headers(relief_framework)
relief_in_batches(relief_framework)

# The page shows a task's file by this name, as other systems do.
add_compile_options(-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)

set(RELIEF_MAIN ${PROJECT_SOURCE_DIR}/framework/course/web/web.cpp)
relief_add_labs(${PROJECT_SOURCE_DIR}/labs)
target_link_libraries(relief PRIVATE nlohmann_json::nlohmann_json PNG::PNG)
# The JavaScript around the module evaluates no text, so that a page can forbid it.
target_link_options(relief PRIVATE --no-entry -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
  -sALLOW_MEMORY_GROWTH=1 -sINITIAL_MEMORY=64MB -sTOTAL_STACK=4MB -sDYNAMIC_EXECUTION=0
  -sMODULARIZE=1 -sEXPORT_NAME=openRelief -sFORCE_FILESYSTEM=1 -sEXPORTED_RUNTIME_METHODS=ccall,FS,HEAPF32
  -sENVIRONMENT=web)
# The functions of task.cpp are undefined: the page gives them to the module (see framework/staff/web/compiled_task.js).
target_link_options(relief PRIVATE -sERROR_ON_UNDEFINED_SYMBOLS=0 -sWARN_ON_UNDEFINED_SYMBOLS=0)
# Emscripten's tools want Debian's modules of Node.js, also with a Node.js from elsewhere.
set_property(TARGET relief PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
