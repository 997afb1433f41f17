#include <stickslip/base/command_line.h>

#include <stickslip/simulation/program.h>

// Written by the build system, for this file only: what a commit changes is
// the program, not the library and its tests.
#include "source_commit.h"

int
main(int argc, char **argv)
{
  stickslip::set_source_commit(STICKSLIP_SOURCE_COMMIT);
  return stickslip::run_program(argc, argv);
}
