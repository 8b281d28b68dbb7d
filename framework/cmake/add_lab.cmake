# Labs: every folder of labs/ with a lab.toml is a lab. No other file lists them.
#
# relief_add_labs(FOLDER) adds an executable lab-NN for each FOLDER/NN_name, with that lab alone, and the executable
# `relief` with all of them, and check-NN for a lab with a C++ task. It sets RELIEF_LABS to the list of their object libraries. All are linked to the library of
# exact values if it exists, even if they call nothing in it, because it says that it is there.
include(${CMAKE_CURRENT_LIST_DIR}/calls.cmake)
include(CheckCXXSourceCompiles)

# Adds the executable check-NN, by which `relief check` runs the lab's checks: only task.cpp is compiled again, with the
# assertions of the C++ library, and with sanitizers if they are installed.
function(relief_add_checker number lab_folder)
  set(sanitizers -fsanitize=address,undefined)
  set(CMAKE_REQUIRED_FLAGS ${sanitizers})
  set(CMAKE_REQUIRED_LINK_OPTIONS ${sanitizers})
  check_cxx_source_compiles("int main() { return 0; }" RELIEF_HAS_SANITIZERS)
  add_library(check_objects_${number} OBJECT ${lab_folder}/task.cpp)
  target_compile_definitions(check_objects_${number} PRIVATE _GLIBCXX_ASSERTIONS RELIEF_LAB_FOLDER="")
  target_include_directories(check_objects_${number} PRIVATE ${lab_folder})
  target_link_libraries(check_objects_${number} PRIVATE relief_framework relief_warnings)
  # -g1: reports then name lines.
  target_compile_options(check_objects_${number} PRIVATE -O1 -g1)
  add_executable(check-${number} ${RELIEF_MAIN}
    $<TARGET_OBJECTS:check_objects_${number}>
    "$<FILTER:$<TARGET_OBJECTS:lab_objects_${number}>,EXCLUDE,/task\\.cpp\\.>")
  target_link_libraries(check-${number} PRIVATE relief_framework $<TARGET_NAME_IF_EXISTS:relief_truth>)
  target_link_options(check-${number} PRIVATE $<$<PLATFORM_ID:Linux>:LINKER:--no-as-needed>)
  if(RELIEF_HAS_SANITIZERS)
    # A report does not end the process, so the check's verdict is that of the program without sanitizers.
    target_compile_options(check_objects_${number} PRIVATE ${sanitizers} -fsanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(check-${number} PRIVATE ${sanitizers})
    target_sources(check-${number} PRIVATE ${PROJECT_SOURCE_DIR}/framework/course/app/sanitizers.cpp)
  endif()
endfunction()

function(relief_add_labs folder)
  file(GLOB manifests CONFIGURE_DEPENDS ${folder}/*/lab.toml)
  set(labs)
  set(programs)
  foreach(manifest IN LISTS manifests)
    cmake_path(GET manifest PARENT_PATH lab_folder)
    cmake_path(GET lab_folder FILENAME name)
    if(NOT name MATCHES "^([0-9][0-9])_[a-z][a-z0-9_]*$")
      message(FATAL_ERROR "labs/${name}: a lab's folder is named like 07_baking")
    endif()
    set(number ${CMAKE_MATCH_1})
    file(GLOB sources CONFIGURE_DEPENDS ${lab_folder}/*.cpp)
    if(EMSCRIPTEN)
      list(REMOVE_ITEM sources ${lab_folder}/task.cpp)  # the page compiles it: see framework/course/web
    endif()
    set(exact_values)
    if(NOT RELIEF_STUDENTS_HALF)
      file(GLOB exact_values CONFIGURE_DEPENDS ${lab_folder}/staff/*.cpp)
      list(FILTER exact_values EXCLUDE REGEX "/staff/bench\\.cpp$")  # a part of librelief-staff
      list(APPEND sources ${exact_values})
      # The grader links a student's C++ task with the other objects of its lab.
      file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/generated/lab_objects/${name}
        CONTENT "$<JOIN:$<TARGET_OBJECTS:lab_objects_${number}>,\n>")
    endif()
    if(EXISTS ${lab_folder}/task.h)
      relief_write_calls(${lab_folder} ${PROJECT_BINARY_DIR}/generated/calls/${name}.cpp)
      list(APPEND sources ${PROJECT_BINARY_DIR}/generated/calls/${name}.cpp)
    endif()
    if(TARGET lab_objects_${number})
      message(FATAL_ERROR "two labs have the number ${number}: labs/${name} is the second")
    endif()
    add_library(lab_objects_${number} OBJECT ${sources})
    target_compile_definitions(lab_objects_${number} PRIVATE RELIEF_LAB_FOLDER="${name}")
    target_include_directories(lab_objects_${number} PRIVATE ${lab_folder})
    target_link_libraries(lab_objects_${number} PUBLIC relief_framework $<TARGET_NAME_IF_EXISTS:relief_truth>
      PRIVATE relief_warnings)
    if(COMMAND relief_takes_precompiled_headers)  # undefined if the framework was built elsewhere
      relief_takes_precompiled_headers(lab_objects_${number})
      # In one piece, except what students edit and the staff's files, which the grader does not link.
      relief_in_batches(lab_objects_${number})
      set_source_files_properties(${lab_folder}/task.cpp ${exact_values} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
    list(APPEND labs lab_objects_${number})
    if(RELIEF_ONE_PROGRAM)
      continue()
    endif()

    add_executable(lab-${number} ${RELIEF_MAIN})
    target_link_libraries(lab-${number} PRIVATE lab_objects_${number})
    target_link_options(lab-${number} PRIVATE $<$<PLATFORM_ID:Linux>:LINKER:--no-as-needed>)
    list(APPEND programs lab-${number})
    if(EXISTS ${lab_folder}/task.cpp AND NOT RELIEF_SANITIZE)
      relief_add_checker(${number} ${lab_folder})
      list(APPEND programs check-${number})
    endif()
  endforeach()
  add_executable(relief ${RELIEF_MAIN})
  target_link_libraries(relief PRIVATE ${labs})
  if(RELIEF_ONE_PROGRAM)
    target_link_libraries(relief PRIVATE relief_framework relief_cpu relief_glad
      $<TARGET_NAME_IF_EXISTS:relief_window>)
    set_target_properties(relief PROPERTIES ENABLE_EXPORTS ON)
    if(WIN32)
      target_link_options(relief PRIVATE -static ${PROJECT_SOURCE_DIR}/framework/cmake/entry_points.def
        LINKER:--wrap=mbrtowc)
    endif()
  else()
    target_link_options(relief PRIVATE $<$<PLATFORM_ID:Linux>:LINKER:--no-as-needed>)
  endif()
  # `course` builds all that a student runs.
  add_custom_target(course DEPENDS relief ${programs} relief_modules)
  set(RELIEF_LABS ${labs} PARENT_SCOPE)
endfunction()
