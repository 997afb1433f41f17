#ifndef stickslip_simulation_program_h
#define stickslip_simulation_program_h

namespace stickslip
{
  /**
   * The whole program: starts MPI, reads the command line, does what it says,
   * and turns errors into messages and exit codes. What main() returns.
   *
   * A program of your own registers its laws first
   * (register_constitutive_law()) and then calls this. Collective.
   */
  int
  run_program(int argc, char **argv);
} // namespace stickslip

#endif
