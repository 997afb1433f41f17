#include <stickslip/output/diagnosis_output.h>

#include <stickslip/base/user_error.h>

#include <stickslip/output/csv.h>
#include <stickslip/output/output_directory.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace stickslip
{
  namespace
  {
    constexpr char prefix[] = "diagnosis-";

    constexpr std::array<const char *, 10> scalar_names{{"pair",
                                                         "status",
                                                         "period",
                                                         "changes_facet",
                                                         "facet_changes",
                                                         "gap",
                                                         "pressure",
                                                         "Lambda",
                                                         "paired",
                                                         "was_paired"}};



    /// In the order of scalar_names.
    template <int dim>
    std::array<double, scalar_names.size()>
    scalars(const PointDiagnosis<dim> &point)
    {
      return {{double(point.pair),
               double(static_cast<unsigned int>(point.state)),
               double(point.period),
               double(point.changes_facet),
               double(point.n_facet_changes),
               point.gap,
               point.pressure,
               point.Lambda,
               double(point.state != ContactState::unpaired),
               double(point.was_paired)}};
    }



    /// The points as patches without extent, for deal.II's parallel writers.
    template <int dim>
    class PointPatches : public DataOutInterface<0, dim>
    {
    public:
      using Patch = DataOutBase::Patch<0, dim>;

      explicit PointPatches(const std::vector<PointDiagnosis<dim>> &points)
      {
        for (const auto &point : points)
          {
            Patch patch;
            patch.vertices[0] = point.position;
            patch.patch_index = patches.size();
            patch.data.reinit(scalar_names.size(), 1);
            const auto values = scalars(point);
            for (unsigned int i = 0; i < values.size(); ++i)
              patch.data(i, 0) = values[i];
            patches.push_back(patch);
          }
      }

    private:
      const std::vector<Patch> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        return {scalar_names.begin(), scalar_names.end()};
      }

      std::vector<Patch> patches;
    };



    const char *
    name_of(const ContactState state)
    {
      switch (state)
        {
          case ContactState::unpaired:
            return "unpaired";
          case ContactState::open:
            return "open";
          case ContactState::stick:
            return "stick";
          case ContactState::slip:
            return "slip";
          case ContactState::tied:
            return "tied";
          case ContactState::closed:
            break;
        }
      return "closed";
    }



    /// In words; empty: nothing was done.
    template <int dim>
    std::string
    treatment_of(const PointDiagnosis<dim> &point)
    {
      return point.treatment == PointTreatment::none && point.keeps_facet
               ? "kept on its facet"
               : name_of(point.treatment);
    }



    template <int dim>
    std::string
    csv_header()
    {
      std::string text = "pair,point";
      for (const char *position : {"reference_", ""})
        for (unsigned int d = 0; d < dim; ++d)
          text += std::string(",") + position + "xyz"[d];
      return text +
             ",status,history,cycle,period,changes_facet,facet_changes,gap,"
             "pressure,Lambda,master_facet,was_paired,treatment\n";
    }



    template <int dim>
    std::string
    csv_line(const PointDiagnosis<dim> &point, const std::string &pair_name)
    {
      std::string line = quoted_for_csv(pair_name) + ',' + point.name;
      const auto add = [&line](const std::string &cell) { line += ',' + cell; };
      for (const Point<dim> &x : {point.reference_position, point.position})
        for (unsigned int d = 0; d < dim; ++d)
          add(exact_number(x[d]));
      add(name_of(point.state));
      add(point.history);
      add(point.cycle ? name_of(*point.cycle) : "");
      add(std::to_string(point.period));
      add(std::to_string(point.changes_facet));
      add(std::to_string(point.n_facet_changes));
      for (const double value : {point.gap, point.pressure, point.Lambda})
        add(exact_number(value));
      add(point.facet);
      add(std::to_string(point.was_paired));
      add(quoted_for_csv(treatment_of(point)));
      return line + '\n';
    }



    /// The table on rank 0.
    template <int dim>
    std::string
    csv_text(const std::vector<PointDiagnosis<dim>> &points,
             const std::vector<std::string>         &pair_names,
             const MPI_Comm                          communicator)
    {
      std::vector<std::string> lines;
      for (const auto &point : points)
        lines.push_back(csv_line(point, pair_names[point.pair]));
      std::vector<std::string> all;
      for (const auto &of_rank : Utilities::MPI::gather(communicator, lines))
        all.insert(all.end(), of_rank.begin(), of_rank.end());
      std::sort(all.begin(), all.end());
      std::string text = csv_header<dim>();
      for (const std::string &line : all)
        text += line;
      return text;
    }
  } // namespace



  template <int dim>
  std::string
  write_diagnosis(const std::string                      &directory,
                  const unsigned int                      step,
                  const std::vector<PointDiagnosis<dim>> &points,
                  const std::vector<std::string>         &pair_names,
                  const MPI_Comm                          communicator)
  {
    if (Utilities::MPI::sum(points.size(), communicator) == 0)
      return "";
    const std::string     name = prefix + Utilities::int_to_string(step, 4);
    const std::string     path = directory + "/" + name;
    PointPatches<dim>     patches(points);
    DataOutBase::VtkFlags flags;
    flags.print_date_and_time = false;
    patches.set_flags(flags);
    patches.write_vtu_in_parallel(path + ".vtu", communicator);

    const std::string csv = csv_text(points, pair_names, communicator);
    std::string       error;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      error = write_file_atomically(path + ".csv", csv);
    throw_collectively(error, communicator);
    return name;
  }



  template std::string
  write_diagnosis(const std::string &,
                  const unsigned int,
                  const std::vector<PointDiagnosis<2>> &,
                  const std::vector<std::string> &,
                  const MPI_Comm);
  template std::string
  write_diagnosis(const std::string &,
                  const unsigned int,
                  const std::vector<PointDiagnosis<3>> &,
                  const std::vector<std::string> &,
                  const MPI_Comm);
} // namespace stickslip
