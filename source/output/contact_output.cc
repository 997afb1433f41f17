#include <stickslip/output/contact_output.h>

#include <stickslip/base/over_ranks.h>

#include <stickslip/output/contact_points_table.h>
#include <stickslip/output/linear_simplices.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace stickslip
{
  namespace
  {
    /// The fields, in the order of the rows of a patch's data.
    constexpr std::array<const char *, 7> contact_vector_names{
      {"displacement",
       "tangential_traction",
       "slip",
       "accumulated_slip",
       "normal",
       "Lambda",
       "traction"}};
    constexpr std::array<const char *, 6> contact_scalar_names{
      {"pressure", "lambda_n", "gap", "paired", "status", "pair"}};

    /**
     * Faces as patches: lets deal.II's parallel writers do their work on data
     * that do not come from a triangulation.
     */
    template <int dim>
    class ContactPatches : public DataOutInterface<dim - 1, dim>
    {
    public:
      using Patch = DataOutBase::Patch<dim - 1, dim>;

      ContactPatches(const std::vector<ContactFaceResult<dim>> &faces,
                     const bool                                 deformed)
      {
        for (const ContactFaceResult<dim> &face : faces)
          {
            patches.push_back(make_patch(face, deformed));
            patches.back().patch_index = patches.size() - 1;
          }
        if constexpr (dim == 3)
          if (std::any_of(faces.begin(), faces.end(), [](const auto &face) {
                return face.degree > 1 && face.cell == ReferenceCells::Triangle;
              }))
            cut_into_linear_simplices(patches);
      }

    private:
      static Patch
      make_patch(const ContactFaceResult<dim> &face, const bool deformed);

      const std::vector<Patch> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        std::vector<std::string> names;
        for (const char *name : contact_vector_names)
          names.insert(names.end(), dim, name);
        names.insert(names.end(),
                     contact_scalar_names.begin(),
                     contact_scalar_names.end());
        return names;
      }

      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        std::vector<
          std::tuple<unsigned int,
                     unsigned int,
                     std::string,
                     DataComponentInterpretation::DataComponentInterpretation>>
          ranges;
        for (unsigned int v = 0; v < contact_vector_names.size(); ++v)
          ranges.emplace_back(
            v * dim,
            v * dim + dim - 1,
            contact_vector_names[v],
            DataComponentInterpretation::component_is_part_of_vector);
        return ranges;
      }

      std::vector<Patch> patches;
    };



    template <int dim>
    typename ContactPatches<dim>::Patch
    ContactPatches<dim>::make_patch(const ContactFaceResult<dim> &face,
                                    const bool                    deformed)
    {
      const unsigned int n_nodes = face.reference_positions.size();
      const unsigned int degree  = face.degree;
      AssertDimension(face.displacements.size(), n_nodes);
      AssertDimension(face.lambda_n.size(), n_nodes);
      AssertDimension(face.Lambda.size(), n_nodes);

      const ContactNodalFields<dim> fields(face);

      Patch patch;
      patch.reference_cell       = face.cell;
      patch.n_subdivisions       = degree;
      patch.points_are_available = true;
      patch.data.reinit(dim * contact_vector_names.size() +
                          contact_scalar_names.size() + dim,
                        n_nodes);

      std::vector<Point<dim>> positions = face.reference_positions;
      if (deformed)
        for (unsigned int i = 0; i < n_nodes; ++i)
          positions[i] += face.displacements[i];

      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          // The positions are the last rows: deal.II's convention.
          const Tensor<1, dim> traction = -face.lambda_n[i] * fields.normal[i] +
                                          fields.tangential_traction[i];
          unsigned int row = 0;
          for (const Tensor<1, dim> &vector : {face.displacements[i],
                                               fields.tangential_traction[i],
                                               fields.slip[i],
                                               fields.accumulated_slip[i],
                                               fields.normal[i],
                                               face.Lambda[i],
                                               traction})
            for (unsigned int d = 0; d < dim; ++d)
              patch.data(row++, i) = vector[d];
          for (const double scalar : {-face.lambda_n[i],
                                      face.lambda_n[i],
                                      fields.gap[i],
                                      fields.paired[i],
                                      static_cast<double>(fields.state),
                                      static_cast<double>(face.pair)})
            patch.data(row++, i) = scalar;
          for (unsigned int d = 0; d < dim; ++d)
            patch.data(row++, i) = positions[i][d];
        }

      for (const unsigned int v : face.cell.vertex_indices())
        {
          const unsigned int i = v % 2, j = v / 2;
          patch.vertices[v] = face.cell == ReferenceCells::Triangle
                                ? positions[v]
                                : positions[degree * (i + j * (degree + 1))];
        }
      return patch;
    }



    /// The state that most of the area has; of equal ones the more active.
    template <int dim>
    ContactState
    prevailing_state(const ContactFaceResult<dim> &face)
    {
      std::array<double, n_contact_states> area{};
      double                               total = 0.;
      for (const ContactPointResult<dim> &point : face.all_points())
        {
          area[static_cast<unsigned int>(point.state)] +=
            point.reference_weight;
          total += point.reference_weight;
        }
      unsigned int result = 0;
      for (unsigned int s = 1; s < n_contact_states; ++s)
        if (area[s] > 0. && area[s] >= area[result] - 1e-10 * total)
          result = s;
      return static_cast<ContactState>(result);
    }
  } // namespace



  template <int dim>
  ContactNodalFields<dim>::ContactNodalFields(
    const ContactFaceResult<dim> &face)
    : tangential_traction(face.reference_positions.size())
    , gap(face.reference_positions.size(), 0.)
    , paired(face.reference_positions.size(), 0.)
    , slip(face.reference_positions.size())
    , accumulated_slip(face.reference_positions.size())
    , normal(face.reference_positions.size())
    , state(prevailing_state(face))
  {
    const auto points = face.all_points();
    for (unsigned int i = 0; i < gap.size(); ++i)
      {
        double weight_of_all = 0., weight_of_paired = 0.;
        for (const ContactPointResult<dim> &point : points)
          {
            AssertDimension(point.shape_values.size(), gap.size());
            const double weight =
              std::max(point.shape_values[i], 0.) * point.reference_weight;
            weight_of_all += weight;
            tangential_traction[i] += weight * point.tangential_traction;
            slip[i] += weight * point.slip;
            accumulated_slip[i] += weight * point.accumulated_slip;
            // An unpaired point has neither a gap nor a normal.
            if (point.state != ContactState::unpaired)
              {
                weight_of_paired += weight;
                gap[i] += weight * point.gap;
                normal[i] += weight * point.normal;
              }
          }
        if (weight_of_all > 0.)
          {
            tangential_traction[i] /= weight_of_all;
            slip[i] /= weight_of_all;
            accumulated_slip[i] /= weight_of_all;
            paired[i] = weight_of_paired / weight_of_all;
          }
        if (weight_of_paired > 0.)
          gap[i] /= weight_of_paired;
        if (normal[i].norm() > 0.)
          normal[i] /= normal[i].norm();
      }
  }



  template <int dim>
  ContactOutput<dim>::ContactOutput(const OutputParameters &parameters,
                                    const MPI_Comm          communicator)
    : deformed(parameters.deformed)
    , higher_order_cells(parameters.format == FieldFormat::vtu)
    , writes_points(parameters.contact_points)
    , directory(parameters.directory)
    , communicator(communicator)
    , series(parameters, "contact", communicator)
    , lines(parameters, communicator)
  {}



  template <int dim>
  void
  ContactOutput<dim>::resume(const double time)
  {
    series.resume(time);
    lines.resume(time);
  }



  template <int dim>
  void
  ContactOutput<dim>::write(const unsigned int                         step,
                            const double                               time,
                            const std::vector<ContactFaceResult<dim>> &faces)
  {
    unsigned int  degree = 1;
    ReferenceCell cell   = ReferenceCells::get_hypercube<dim - 1>();
    for (const ContactFaceResult<dim> &face : faces)
      {
        degree = std::max(degree, face.degree);
        if (cell != ReferenceCells::Triangle) // if there is any
          cell = face.cell;
      }
    degree = Utilities::MPI::max(degree, communicator);
    const bool has_triangles =
      any_rank(cell == ReferenceCells::Triangle, communicator);

    ContactPatches<dim>   patches(faces, deformed);
    DataOutBase::VtkFlags flags;
    flags.compression_level   = decltype(flags.compression_level)::best_speed;
    flags.print_date_and_time = false;
    // deal.II 9.4 has no node numbering of Lagrange curves: subdivided lines.
    // Nor can it write curved quadrilaterals beside triangles.
    flags.write_higher_order_cells =
      dim == 3 && higher_order_cells && degree > 1 && !has_triangles;
    patches.set_flags(flags);
    series.write(patches, step, time, cell);
    lines.write(step, time, faces);
    if (writes_points)
      write_contact_points(directory + "/contact_points-" +
                             Utilities::int_to_string(step, 4) + ".csv",
                           faces,
                           communicator);
  }



  template struct ContactNodalFields<2>;
  template struct ContactNodalFields<3>;
  template class ContactOutput<2>;
  template class ContactOutput<3>;
} // namespace stickslip
