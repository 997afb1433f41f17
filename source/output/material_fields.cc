#include <stickslip/output/material_fields.h>

#include <utility>

namespace stickslip
{
  template <int dim>
  MaterialFields<dim>
  material_fields(SolidAssembler<dim> &solid, const LA::Vector &displacement)
  {
    MaterialFields<dim> fields;
    fields.history_names = solid.history_names();
    fields.evaluate      = [&solid, &displacement](const auto &cell) {
      std::vector<typename SolidAssembler<dim>::PointState> states;
      solid.evaluate_point_states(cell, displacement, states);
      typename MaterialFields<dim>::Values values;
      for (auto &state : states)
        {
          values.cauchy_stress.push_back(state.cauchy_stress);
          values.strain.push_back(state.strain);
          values.history.push_back(std::move(state.history));
        }
      return values;
    };
    return fields;
  }



  template MaterialFields<2>
  material_fields(SolidAssembler<2> &, const LA::Vector &);
  template MaterialFields<3>
  material_fields(SolidAssembler<3> &, const LA::Vector &);
} // namespace stickslip
