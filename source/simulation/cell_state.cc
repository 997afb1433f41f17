#include <stickslip/simulation/cell_state.h>

#include <stickslip/mesh/cell_distribution.h>

#include <deal.II/base/array_view.h>


namespace stickslip
{
  namespace
  {
    /// Appends what it meets to a record.
    struct RecordAppender
    {
      static constexpr bool is_reading = false;

      std::vector<double> &record;

      template <typename Number>
      void
      operator()(const Number &number)
      {
        record.push_back(number);
      }

      void
      entry(const LA::Vector &vector, const types::global_dof_index i)
      {
        record.push_back(vector(i));
      }

      void
      cell_history(PointHistory &history, const unsigned int cell)
      {
        const auto values = history.accepted_of_cell(cell);
        record.insert(record.end(), values.begin(), values.end());
      }
    };



    /// Sets what it meets from a record; zero beyond its end.
    struct RecordExtractor
    {
      static constexpr bool is_reading = true;

      const std::vector<double> &record;
      std::size_t                position = 0;

      double
      next()
      {
        const double value = position < record.size() ? record[position] : 0.;
        ++position;
        return value;
      }

      template <typename Number>
      void
      operator()(Number &number)
      {
        number = static_cast<Number>(next());
      }

      void
      entry(LA::Vector &vector, const types::global_dof_index i)
      {
        vector(i) = next();
      }

      void
      cell_history(PointHistory &history, const unsigned int cell)
      {
        std::vector<double> values(history.accepted_of_cell(cell).size());
        for (double &value : values)
          value = next();
        history.set_cell(cell,
                         ArrayView<const double>(values.data(), values.size()));
      }
    };
  } // namespace



  template <int dim>
  PartitionFreeNames<dim>::PartitionFreeNames(
    const Triangulation<dim> &triangulation)
  {
    if (const auto *p4est =
          dynamic_cast<const parallel::distributed::Triangulation<dim> *>(
            &triangulation))
      {
        names = p4est->get_p4est_tree_to_coarse_cell_permutation();
        ids   = p4est->get_coarse_cell_to_p4est_tree_permutation();
      }
    else if (const auto *metis =
               dynamic_cast<const PartitionedTriangulation<dim> *>(
                 &triangulation))
      {
        names = metis->joined_numbers;
        ids   = metis->coarse_ids;
      }
    else
      AssertThrow(false, ExcMessage("Cells of an unknown order."));
  }



  template <int dim>
  CellKey
  PartitionFreeNames<dim>::name_of(const CellId &id) const
  {
    CellKey name = id.to_binary<dim>();
    name[0]      = coarse_name(name[0]);
    return name;
  }



  template <int dim>
  unsigned int
  PartitionFreeNames<dim>::coarse_name(const unsigned int coarse_id) const
  {
    return names[coarse_id];
  }



  template <int dim>
  unsigned int
  PartitionFreeNames<dim>::coarse_id(const unsigned int coarse_name) const
  {
    return ids[coarse_name];
  }



  template <int dim>
  CellState<dim>::CellState(ContactProblem<dim> &problem)
    : problem(problem)
    , names(problem.layout().dof_handler.get_triangulation())
  {
    for (const auto &pair : problem.contact().contact_pairs())
      {
        SlaveFaces faces;
        for (unsigned int f = 0; f < pair->slave_faces.size(); ++f)
          faces.of_cell[pair->slave_faces[f].face.id.cell].push_back(f);
        faces.first_point.resize(pair->slave_faces.size() + 1);
        for (const auto &point : pair->points)
          ++faces.first_point[point.geometry.slave_face + 1];
        for (unsigned int f = 0; f < pair->slave_faces.size(); ++f)
          faces.first_point[f + 1] += faces.first_point[f];
        slave_faces.push_back(faces);
      }
  }



  template <int dim>
  template <class Cursor>
  void
  CellState<dim>::walk_side(Side &side, Cursor &cursor) const
  {
    auto number = static_cast<unsigned int>(side);
    cursor(number);
    side = static_cast<Side>(number);
  }



  template <int dim>
  template <class Cursor>
  void
  CellState<dim>::walk_contact_point(ContactPoint<dim> &point,
                                     Cursor            &cursor) const
  {
    for (unsigned int c = 0; c < dim; ++c)
      cursor(point.accumulated_slip[c]);
    // adapted regularization is kept from step to step
    cursor(point.treatment.r_n_factor);
    cursor(point.treatment.r_t_factor);
    // what the next pairing starts from; the rest follows from it
    auto          state   = point.hysteresis.accepted();
    Pairing<dim> &pairing = state.pairing;
    FaceId       &face    = pairing.face_id;
    cursor(pairing.paired);
    // a point without a partner has no cell to name
    unsigned int coarse_cell =
      pairing.paired ? names.coarse_name(face.cell[0]) : 0;
    cursor(coarse_cell);
    face.cell[0] = pairing.paired ? names.coarse_id(coarse_cell) : 0;
    for (unsigned int i = 1; i < face.cell.size(); ++i)
      cursor(face.cell[i]);
    cursor(face.face);
    cursor(face.image);
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        cursor(pairing.xi[d]);
        cursor(pairing.free[d]);
      }
    cursor(state.facet_changes);
    cursor(state.kept_beyond_end);
    if (Cursor::is_reading)
      point.hysteresis.resume(state);
  }



  template <int dim>
  template <class Cursor, class Fields>
  void
  CellState<dim>::walk(const CellIterator &cell, Cursor &cursor, Fields &fields)
  {
    dof_indices.resize(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(dof_indices);
    for (const auto i : dof_indices)
      {
        cursor.entry(fields.displacement, i);
        cursor.entry(fields.nodal_forces, i);
        cursor.entry(fields.contact_forces, i);
        cursor.entry(fields.rate, i);
      }
    cursor.cell_history(problem.solid().point_history(),
                        cell->active_cell_index());
    cursor(fields.indicators[cell->active_cell_index()]);

    const auto key = cell->id().template to_binary<dim>();
    for (unsigned int p = 0; p < slave_faces.size(); ++p)
      {
        ContactPair<dim> &pair  = *problem.contact().contact_pairs()[p];
        const auto        faces = slave_faces[p].of_cell.find(key);
        if (faces == slave_faces[p].of_cell.end())
          continue;
        for (const unsigned int f : faces->second)
          {
            if (pair.meets_itself())
              walk_side(pair.slave_faces[f].side, cursor);
            for (const auto i : pair.slave_faces[f].multiplier_dofs)
              cursor.entry(fields.multipliers, i);
            for (unsigned int i = slave_faces[p].first_point[f];
                 i < slave_faces[p].first_point[f + 1];
                 ++i)
              walk_contact_point(pair.points[i], cursor);
          }
      }
  }



  template <int dim>
  void
  CellState<dim>::write(const CellIterator  &cell,
                        const StateVectors  &fields,
                        std::vector<double> &record)
  {
    record.clear();
    RecordAppender cursor{record};
    walk(cell, cursor, fields);
  }



  template <int dim>
  bool
  CellState<dim>::read(const CellIterator        &cell,
                       const std::vector<double> &record,
                       StateVectors              &fields)
  {
    RecordExtractor cursor{record};
    walk(cell, cursor, fields);
    return cursor.position == record.size();
  }

  template class PartitionFreeNames<2>;
  template class PartitionFreeNames<3>;
  template class CellState<2>;
  template class CellState<3>;
} // namespace stickslip
