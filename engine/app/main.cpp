// Where the program starts.
#include "app/command_line.h"

int main(int argc, char** argv) { return enfilade::run_command_line(argc, argv); }
