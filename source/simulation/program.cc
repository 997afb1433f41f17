#include <stickslip/simulation/program.h>

#include <stickslip/base/command_line.h>
#include <stickslip/base/no_convergence.h>
#include <stickslip/base/print_parameters.h>
#include <stickslip/base/short_message.h>
#include <stickslip/base/stop_requests.h>
#include <stickslip/base/user_error.h>

#include <stickslip/mesh/generator_page.h>
#include <stickslip/mesh/mesh_inspection_text.h>

#include <stickslip/output/output_directory.h>

#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/checkpoint_mesh.h>
#include <stickslip/simulation/run_files.h>
#include <stickslip/simulation/run_summary.h>
#include <stickslip/simulation/simulation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace stickslip
{
  namespace
  {
    /// What the shell sees; documented in help_text().
    enum ExitCode
    {
      success           = 0,
      wrong_input       = 1,
      no_convergence    = 2,
      internal_error    = 3,
      check_falls_short = 4,
      stopped           = 5
    };



    /**
     * Large blocks of memory go back to the system when they are freed. That is
     * how the C library starts, but SuperLU_DIST, which comes with PETSc,
     * switches it off when it is loaded.
     */
    void
    return_free_memory()
    {
#ifdef __GLIBC__
      mallopt(M_MMAP_MAX, 65536);
      mallopt(M_MMAP_THRESHOLD, 1 << 20);
      mallopt(M_TRIM_THRESHOLD, 1 << 20);
#endif
    }



    /**
     * OpenBLAS takes as many threads as there are cores, in every rank: on one
     * rank they help MUMPS, those of several ranks wait for each other. Whoever
     * sets one of its variables has chosen.
     */
    void
    share_cores_among_ranks()
    {
      using SetThreads       = void (*)(int);
      const auto set_threads = reinterpret_cast<SetThreads>(
        dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
      const bool is_chosen = std::getenv("OPENBLAS_NUM_THREADS") != nullptr ||
                             std::getenv("OMP_NUM_THREADS") != nullptr;
      if (set_threads != nullptr && !is_chosen &&
          Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        set_threads(1);
    }



    bool
    is_speaker()
    {
      return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    }



    template <int dim>
    int
    run_case(CaseParameters &parameters, const CommandLine &command_line)
    {
      const bool is_validation =
        command_line.action == CommandLine::Action::validate;
      if (!is_validation)
        {
          catch_stop_signals();
          prepare_output_directory(parameters.output.directory, MPI_COMM_WORLD);
          if (!command_line.restart.empty())
            parameters.mesh.goes_on_refined = is_of_adapted_mesh(
              find_run_start(parameters, command_line.restart, MPI_COMM_WORLD)
                .checkpoint,
              MPI_COMM_WORLD);
        }
      Simulation<dim> simulation(parameters, MPI_COMM_WORLD);
      if (is_validation)
        {
          const auto lines = simulation.description_of_start();
          if (is_speaker())
            {
              for (const std::string &line : lines)
                std::cout << line << '\n';
              std::cout << command_line.parameter_file << ": no errors found."
                        << std::endl;
            }
          return success;
        }
      return simulation.run(command_line.restart) == 0 ? success
                                                       : check_falls_short;
    }



    /// Reads the case that the command line names, also into @p prm.
    void
    read_case(const CommandLine &command_line,
              CaseParameters    &parameters,
              ParameterHandler  &prm)
    {
      ParameterFile file(command_line.parameter_file, MPI_COMM_WORLD);
      for (const std::string &assignment : command_line.overrides)
        file.override_with(assignment);
      if (!command_line.output_directory.empty())
        file.override_with("Output/Directory=" + command_line.output_directory);
      parameters.read(file, prm, MPI_COMM_WORLD);
    }



    void
    print_all_parameters(const CommandLine &command_line)
    {
      CaseParameters   parameters;
      ParameterHandler prm;
      if (command_line.parameter_file.empty())
        CaseParameters::declare_all(parameters, prm);
      else
        read_case(command_line, parameters, prm);
      if (is_speaker())
        {
          print_parameters(std::cout, prm, command_line.format);
          if (command_line.format == ParameterFormat::markdown &&
              command_line.parameter_file.empty())
            print_generators(std::cout);
        }
    }



    void
    print_summary(const std::string &directory)
    {
      throw_collectively(is_speaker() ? summarize_run(directory, std::cout)
                                      : "",
                         MPI_COMM_WORLD);
    }



    /// One rank looks at the file; all throw if it cannot.
    void
    print_mesh(const CommandLine &command_line)
    {
      on_first_rank(
        [&command_line] {
          const MeshInspection inspection =
            inspect_mesh(command_line.mesh_file);
          (command_line.json ? print_inspection_json
                             : print_inspection)(std::cout, inspection);
        },
        MPI_COMM_WORLD);
    }



    int
    act_on(const CommandLine &command_line)
    {
      switch (command_line.action)
        {
          case CommandLine::Action::help:
            if (is_speaker())
              std::cout << help_text();
            return success;
          case CommandLine::Action::version:
            if (is_speaker())
              std::cout << version_text();
            return success;
          case CommandLine::Action::print_parameters:
            print_all_parameters(command_line);
            return success;
          case CommandLine::Action::diagnose:
            print_summary(command_line.output_directory);
            return success;
          case CommandLine::Action::inspect_mesh:
            print_mesh(command_line);
            return success;
          default:
            break;
        }

      CaseParameters   parameters;
      ParameterHandler prm;
      read_case(command_line, parameters, prm);
      if (command_line.is_quiet)
        parameters.output.verbosity = Verbosity::quiet;
      return parameters.dimension == 2 ? run_case<2>(parameters, command_line)
                                       : run_case<3>(parameters, command_line);
    }
  } // namespace



  int
  run_program(int argc, char **argv)
  {
    // PETSc, which deal.II may bring along, would take our arguments for its
    // own and complain that it knows none of them.
    std::array<char *, 2> name{{argc > 0 ? argv[0] : nullptr, nullptr}};
    int                   n_names = std::min(argc, 1);
    char                **names   = name.data();
    // One thread per rank: MPI is the parallelism.
    dealii::Utilities::MPI::MPI_InitFinalize mpi(n_names, names, 1);
    return_free_memory();
    share_cores_among_ranks();
    const auto report = [](const std::string &kind, const std::string &text) {
      if (is_speaker())
        std::cerr << "stickslip: " << kind << ": " << without_long_words(text)
                  << std::endl;
    };
    try
      {
        return act_on(parse_command_line(argc, argv));
      }
    catch (const UserError &error)
      {
        report("wrong input", error.what());
        return wrong_input;
      }
    catch (const NoConvergence &failure)
      {
        report("no convergence", failure.what());
        return no_convergence;
      }
    catch (const std::bad_alloc &)
      {
        std::cerr << "stickslip: out of memory on rank "
                  << Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)
                  << ": the case needs more than this machine has free. Take a "
                     "coarser mesh, a lower degree or more machines."
                  << std::endl;
        MPI_Abort(MPI_COMM_WORLD, wrong_input);
        return wrong_input;
      }
    catch (const RunStopped &request)
      {
        report("stopped", request.what());
        return stopped;
      }
    catch (const std::exception &error)
      {
        // Possibly on this rank only: the others must not wait for it.
        std::cerr << "stickslip: internal error on rank "
                  << Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) << ": "
                  << without_long_words(error.what()) << std::endl;
        MPI_Abort(MPI_COMM_WORLD, internal_error);
        return internal_error;
      }
  }
} // namespace stickslip
