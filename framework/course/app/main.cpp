#include "framework/course/app/command_line.h"

int main(int argc, char** argv) { return relief::app::run_command_line(argc, argv); }
