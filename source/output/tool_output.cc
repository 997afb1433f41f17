#include <stickslip/output/tool_output.h>

#include <stickslip/contact/surface/tool_tessellation.h>

#include <deal.II/base/data_out_base.h>

#include <deal.II/grid/reference_cell.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

namespace stickslip
{
  namespace
  {
    /// Pieces around a full turn: what looks round.
    constexpr unsigned int n_per_turn = 120;



    template <int dim>
    class ToolPatches : public DataOutInterface<dim - 1, dim>
    {
    public:
      using Patch = DataOutBase::Patch<dim - 1, dim>;

      /// Adds a tool whose frame is the face @p frame.
      void
      add(const RigidTool<dim>   &tool,
          const SurfaceFace<dim> &frame,
          const LA::Vector       &displacement,
          const bool              deformed)
      {
        std::vector<Tensor<1, dim>> now;
        read_positions(frame, frame.n_nodes, displacement, now);
        const auto picture = tessellate(tool.surface, n_per_turn);
        std::vector<Tensor<1, dim>> reference, moved;
        for (const Point<dim> &X : picture.points)
          {
            const auto weights = tool.frame.weights(X);
            reference.push_back(
              interpolate<dim>(weights, frame.undeformed_nodes()));
            moved.push_back(interpolate<dim>(weights, now));
          }
        for (const auto &cell : picture.cells)
          {
            Patch patch;
            patch.patch_index    = patches.size();
            patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
            patch.n_subdivisions = 1;
            patch.points_are_available = false;
            patch.data.reinit(dim, cell.size());
            for (unsigned int v = 0; v < cell.size(); ++v)
              {
                // vertices of quadrilaterals go around them there
                const unsigned int i = cell[v == 2 ? 3 : v == 3 ? 2 : v];
                patch.vertices[v] =
                  Point<dim>(deformed ? moved[i] : reference[i]);
                for (unsigned int d = 0; d < dim; ++d)
                  patch.data(d, v) = (moved[i] - reference[i])[d];
              }
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
        return std::vector<std::string>(dim, "displacement");
      }

      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        return {std::make_tuple(
          0U,
          dim - 1U,
          std::string("displacement"),
          DataComponentInterpretation::component_is_part_of_vector)};
      }

      std::vector<Patch> patches;
    };
  } // namespace



  template <int dim>
  ToolOutput<dim>::ToolOutput(const OutputParameters &parameters,
                              const MPI_Comm          communicator)
    : deformed(parameters.deformed)
    , series(parameters, "tools", communicator)
  {}



  template <int dim>
  void
  ToolOutput<dim>::resume(const double time)
  {
    series.resume(time);
  }



  template <int dim>
  void
  ToolOutput<dim>::write(const unsigned int step,
                         const double       time,
                         const Pairs       &pairs,
                         const LA::Vector  &displacement)
  {
    ToolPatches<dim> patches;
    std::set<FaceId> drawn; // several pairs may meet one tool
    bool             has_tools = false;
    for (const auto &pair : pairs)
      if (const RigidTool<dim> *tool = pair->patch->tool())
        {
          has_tools = true;
          for (const auto &frame : pair->patch->owned_faces())
            if (drawn.insert(frame.id).second)
              patches.add(*tool, frame, displacement, deformed);
        }
    if (has_tools)
      series.write(patches, step, time);
  }

  template class ToolOutput<2>;
  template class ToolOutput<3>;
} // namespace stickslip
