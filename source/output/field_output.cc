#include <stickslip/output/field_output.h>

#include <stickslip/base/user_error.h>

#include <stickslip/mesh/reference_cells.h>

#include <stickslip/output/linear_simplices.h>
#include <stickslip/output/stress_projection.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/mapping_fe_field.h>
#include <deal.II/fe/mapping_q_eulerian.h>

#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Per active cell: body, material region and rank.
    template <int dim>
    struct CellFields
    {
      CellFields(const Triangulation<dim> &triangulation, const Bodies &bodies)
        : body(triangulation.n_active_cells())
        , material(triangulation.n_active_cells())
        , rank(triangulation.n_active_cells())
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
            {
              const unsigned int i = cell->active_cell_index();
              body[i]              = bodies.body_of(cell->material_id());
              material[i]          = cell->material_id();
              rank[i]              = cell->subdomain_id();
            }
      }

      void
      attach_to(DataOut<dim> &data_out) const
      {
        data_out.add_data_vector(body, "body", DataOut<dim>::type_cell_data);
        data_out.add_data_vector(material,
                                 "material",
                                 DataOut<dim>::type_cell_data);
        data_out.add_data_vector(rank, "rank", DataOut<dim>::type_cell_data);
      }

      Vector<float> body, material, rank;
    };
  } // namespace



  /// Knows by the names of the components which of them are a tensor: deal.II
  /// thinks that a tensor has dim x dim of them. Can have patches of a part
  /// of the cells.
  template <int dim>
  class FieldPatches : public DataOut<dim>
  {
  public:
    using CellIterator = typename Triangulation<dim>::cell_iterator;

    /// After build_patches(): deforms the grid. The displacement is the first
    /// of the data.
    void
    add_displacement_to_positions()
    {
      for (auto &patch : this->patches)
        {
          // Where there are positions, they are the last rows: deal.II's
          // convention. Else the data are those of the vertices.
          const unsigned int positions = patch.data.n_rows() - dim;
          for (unsigned int i = 0; i < patch.data.n_cols(); ++i)
            for (unsigned int d = 0; d < dim; ++d)
              if (patch.points_are_available)
                patch.data(positions + d, i) += patch.data(d, i);
              else
                patch.vertices[i][d] += patch.data(d, i);
        }
    }

    /// After build_patches() with 2 subdivisions.
    void
    cut_quadratic_simplices()
    {
      cut_into_linear_simplices(this->patches);
    }

    /// The next build_patches() is for these cells.
    void
    select(const std::vector<CellIterator> &cells,
           const std::size_t                begin,
           const std::size_t                end)
    {
      // deal.II asks for the cells one after the other, more than once
      this->set_cell_selection(
        [&cells, begin, end](const Triangulation<dim> &triangulation) {
          return begin < end ? cells[begin] : triangulation.end();
        },
        [&cells, begin, end, last = begin](
          const Triangulation<dim> &triangulation,
          const CellIterator       &cell) mutable {
          if (last >= end || cells[last] != cell)
            last = begin; // again
          ++last;
          return last < end ? cells[last] : triangulation.end();
        });
    }

    void
    write_piece(const DataOutBase::VtkFlags &flags, std::ostream &out) const
    {
      DataOutBase::write_vtu_main(this->get_patches(),
                                  this->get_dataset_names(),
                                  this->get_nonscalar_data_ranges(),
                                  flags,
                                  out);
    }

  protected:
    using Range =
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>;

    std::vector<Range>
    get_nonscalar_data_ranges() const override
    {
      std::vector<Range> ranges = DataOut<dim>::get_nonscalar_data_ranges();
      const std::vector<std::string> names = this->get_dataset_names();
      for (const char *tensor : {"cauchy_stress", "strain"})
        {
          const auto first     = std::find(names.begin(), names.end(), tensor);
          const unsigned int i = first - names.begin();
          if (first != names.end())
            ranges.emplace_back(
              i,
              i + 8,
              tensor,
              DataComponentInterpretation::component_is_part_of_tensor);
        }
      return ranges;
    }
  };



  namespace
  {
    /// Where the nodes of the deformed bodies are; ghosted.
    template <int dim>
    LA::Vector
    nodal_positions(const Mapping<dim>    &mapping,
                    const DoFHandler<dim> &dof_handler,
                    const LA::Vector      &displacement)
    {
      const FiniteElement<dim> &fe           = dof_handler.get_fe();
      const IndexSet           &owned        = dof_handler.locally_owned_dofs();
      const MPI_Comm            communicator = dof_handler.get_communicator();
      LA::Vector                positions(owned, communicator);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if (owned.is_element(dofs[i]))
                positions(dofs[i]) =
                  displacement(dofs[i]) +
                  mapping.transform_unit_to_real_cell(
                    cell,
                    fe.unit_support_point(
                      i))[fe.system_to_component_index(i).first];
          }
      positions.compress(VectorOperation::insert);
      IndexSet relevant;
      DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
      LA::Vector ghosted(owned, relevant, communicator);
      ghosted = positions;
      return ghosted;
    }



    /// From the reference cells, of one kind, to the deformed ones. Collective.
    template <int dim>
    hp::MappingCollection<dim>
    mapping_of_deformed(const Mapping<dim>    &mapping,
                        const DoFHandler<dim> &dof_handler,
                        const LA::Vector      &displacement,
                        LA::Vector            &positions)
    {
      if (dof_handler.get_fe().reference_cell().is_simplex() ||
          dof_handler.get_triangulation().has_hanging_nodes())
        {
          positions = nodal_positions(mapping, dof_handler, displacement);
          return hp::MappingCollection<dim>(
            MappingFEField<dim, dim, LA::Vector>(dof_handler, positions));
        }
      return hp::MappingCollection<dim>(MappingQEulerian<dim, LA::Vector>(
        dof_handler.get_fe().degree, dof_handler, displacement));
    }
  } // namespace



  template <int dim>
  FieldOutput<dim>::FieldOutput(const OutputParameters &parameters,
                                const Bodies           &bodies,
                                const MPI_Comm          communicator,
                                const unsigned int      cells_of_piece)
    : cells_of_piece(cells_of_piece)
    , deformed(parameters.deformed)
    , is_vtu(parameters.format == FieldFormat::vtu)
    , bodies(bodies)
    , series(parameters, "solution", communicator)
  {
    for (const Body &body : bodies.bodies)
      if (!is_vtu && body.cells != bodies.bodies.front().cells)
        throw UserError(
          "Output/Format = hdf5 writes cells of one kind only, "
          "but the bodies are made of " +
          plural(bodies.bodies.front().cells) + " and " + plural(body.cells) +
          ". Take 'vtu'.");
  }



  template <int dim>
  void
  FieldOutput<dim>::resume(const double time)
  {
    series.resume(time);
  }



  template <int dim>
  void
  FieldOutput<dim>::write(const unsigned int                step,
                          const double                      time,
                          const hp::MappingCollection<dim> &mapping,
                          const DoFHandler<dim>            &dof_handler,
                          const LA::Vector                 &displacement,
                          const MaterialFields<dim>        &material,
                          const NamedCellValues            &of_cells)
  {
    const unsigned int    degree        = dof_handler.get_fe().degree;
    const auto           &elements      = dof_handler.get_fe_collection();
    const bool            is_mixed      = elements.size() > 1;
    const ReferenceCell   cell          = elements[0].reference_cell();
    const bool            has_simplices = is_mixed || cell.is_simplex();
    const CellFields<dim> cell_fields(dof_handler.get_triangulation(), bodies);
    std::unique_ptr<StressProjection<dim>> projection;

    FieldPatches<dim> data_out;
    data_out.attach_triangulation(dof_handler.get_triangulation());
    const auto cells = cells_to_write(dof_handler.get_triangulation());
    data_out.add_data_vector(
      dof_handler,
      displacement,
      std::vector<std::string>(dim, "displacement"),
      std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        dim, DataComponentInterpretation::component_is_part_of_vector));
    if (material.evaluate)
      {
        projection       = std::make_unique<StressProjection<dim>>(mapping,
                                                             dof_handler,
                                                             material);
        const auto names = projection->names();
        for (unsigned int c = 0; c < names.size(); ++c)
          data_out.add_data_vector(projection->get_dof_handler(),
                                   projection->get_fields()[c],
                                   names[c]);
        projection->clear_fields(); // data_out has copies
      }
    cell_fields.attach_to(data_out);
    for (const auto &[name, values] : of_cells)
      data_out.add_data_vector(values, name, DataOut<dim>::type_cell_data);

    DataOutBase::VtkFlags flags;
    flags.compression_level   = decltype(flags.compression_level)::best_speed;
    flags.print_date_and_time = false;
    // deal.II has no curved cells beside others
    flags.write_higher_order_cells = is_vtu && degree > 1 && !has_simplices;
    data_out.set_flags(flags);

    LA::Vector                       positions; // of the deformed nodes
    const hp::MappingCollection<dim> mapping_of_grid =
      deformed && !is_mixed
        ? mapping_of_deformed(mapping[0], dof_handler, displacement, positions)
        : mapping;
    const auto build = [&](const std::size_t begin, const std::size_t end) {
      data_out.select(cells, begin, end);
      data_out.build_patches(mapping_of_grid,
                             degree,
                             DataOut<dim>::curved_inner_cells);
      if (deformed && is_mixed) // deal.II has no such mapping for two kinds
        data_out.add_displacement_to_positions();
      if (has_simplices && degree > 1)
        data_out.cut_quadratic_simplices();
    };
    const bool is_curved = dim == 3 && flags.write_higher_order_cells;
    if (is_vtu && !is_curved)
      {
        const std::size_t n = cells.size();
        const VtuPieces   pieces{
          static_cast<unsigned int>((n + cells_of_piece - 1) / cells_of_piece),
          [&](const unsigned int k, std::ostream &out) {
            build(std::min(n, std::size_t(k) * cells_of_piece),
                  std::min(n, (std::size_t(k) + 1) * cells_of_piece));
            data_out.write_piece(flags, out);
          }};
        series.write(data_out, pieces, flags, step, time);
        return;
      }
    build(0, cells.size());
    data_out.clear_input_data_references(); // the patches have the values
    series.write(data_out, step, time, cell, is_curved);
  }



  template <int dim>
  std::vector<typename Triangulation<dim>::cell_iterator>
  FieldOutput<dim>::cells_to_write(
    const Triangulation<dim> &triangulation) const
  {
    // the cell of a tool is not what it looks like (ToolOutput)
    std::vector<bool> is_tool;
    for (const auto &body : bodies.bodies)
      is_tool.push_back(body.parameters.is_tool());
    std::vector<typename Triangulation<dim>::cell_iterator> cells;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() &&
          !is_tool[bodies.body_of(cell->material_id())])
        cells.push_back(cell);
    return cells;
  }



  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace stickslip
