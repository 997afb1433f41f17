#include <stickslip/output/contact_points_table.h>

#include <stickslip/base/user_error.h>

#include <stickslip/output/csv.h>
#include <stickslip/output/output_directory.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    template <int dim>
    std::string
    header()
    {
      std::string text       = "pair";
      const auto  add_vector = [&text](const std::string &name) {
        for (unsigned int d = 0; d < dim; ++d)
          text += "," + name + "xyz"[d];
      };
      add_vector("reference_");
      add_vector("");
      text += ",reference_weight,area_ratio,status,gap,pressure";
      for (const char *name :
           {"normal_", "tangential_traction_", "slip_", "accumulated_slip_"})
        add_vector(name);
      return text + "\n";
    }



    /// A row of numbers in the order of header().
    template <int dim>
    std::vector<double>
    numbers(const unsigned int pair, const ContactPointResult<dim> &point)
    {
      std::vector<double> row{static_cast<double>(pair)};
      const auto          add_vector = [&row](const Tensor<1, dim> &vector) {
        row.insert(row.end(), vector.begin_raw(), vector.end_raw());
      };
      add_vector(point.reference_position);
      add_vector(point.position);
      for (const double value :
           {point.reference_weight,
            point.area_ratio,
            static_cast<double>(static_cast<unsigned int>(point.state)),
            point.gap,
            point.pressure})
        row.push_back(value);
      for (const Tensor<1, dim> &vector : {point.normal,
                                           point.tangential_traction,
                                           point.slip,
                                           point.accumulated_slip})
        add_vector(vector);
      return row;
    }
  } // namespace



  template <int dim>
  void
  write_contact_points(const std::string                         &path,
                       const std::vector<ContactFaceResult<dim>> &faces,
                       const MPI_Comm                             communicator)
  {
    using Rows = std::vector<std::vector<double>>;
    Rows rows;
    for (const auto &face : faces)
      for (const auto &point : face.points)
        rows.push_back(numbers(face.pair, point));
    Rows all;
    for (const Rows &of_rank : Utilities::MPI::gather(communicator, rows))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    std::sort(all.begin(), all.end());

    std::string error;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::string text = header<dim>();
        for (const auto &row : all)
          {
            for (unsigned int i = 0; i < row.size(); ++i)
              text += (i == 0 ? "" : ",") + exact_number(row[i]);
            text += '\n';
          }
        error = write_file_atomically(path, text);
      }
    throw_collectively(error, communicator);
  }

  template void
  write_contact_points(const std::string &,
                       const std::vector<ContactFaceResult<2>> &,
                       const MPI_Comm);
  template void
  write_contact_points(const std::string &,
                       const std::vector<ContactFaceResult<3>> &,
                       const MPI_Comm);
} // namespace stickslip
