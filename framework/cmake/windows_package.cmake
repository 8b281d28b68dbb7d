# The target `package` makes a ZIP file that a student unpacks and starts, without a compiler: the program, its fonts,
# and the course's files. Only in a students' course, because the staff's has the solutions.
if(EXISTS ${PROJECT_SOURCE_DIR}/framework/staff)
  add_custom_target(package
    COMMAND ${CMAKE_COMMAND} -E echo "this course has the solutions: make a handout, and the package in it"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
  return()
endif()
install(TARGETS relief RUNTIME DESTINATION .)
install(DIRECTORY assets labs shaders DESTINATION .)
install(FILES README.md LICENSE DESTINATION .)
find_path(RELIEF_FONTS DejaVuSans.ttf NO_CMAKE_FIND_ROOT_PATH
  PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/dejavu-sans-fonts /usr/share/fonts/TTF)
if(RELIEF_FONTS)
  file(GLOB fonts ${RELIEF_FONTS}/DejaVuSans.ttf ${RELIEF_FONTS}/DejaVuSans-Bold.ttf ${RELIEF_FONTS}/DejaVuSansMono.ttf
    ${RELIEF_FONTS}/DejaVuSerif.ttf)
  install(FILES ${fonts} DESTINATION fonts)
endif()
set(CPACK_GENERATOR ZIP)
set(CPACK_PACKAGE_FILE_NAME relief-${PROJECT_VERSION}-windows)
set(CPACK_STRIP_FILES ON)
include(CPack)
