#ifndef stickslip_mesh_by_kind_h
#define stickslip_mesh_by_kind_h

#include <deal.II/hp/fe_collection.h>

#include <memory>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * One object for each kind of cells of a model (reference_cells.h), such as
   * the FEValues of a loop over cells: most models have one kind, and one
   * object.
   */
  template <typename T>
  class ByKind
  {
  public:
    /// @p make returns a unique_ptr for an element, and the number of its
    /// kind.
    template <int dim, typename Make>
    ByKind(const hp::FECollection<dim> &elements, const Make &make)
    {
      for (unsigned int kind = 0; kind < elements.size(); ++kind)
        objects.push_back(make(elements[kind], kind));
    }

    /// That of @p cell of a DoFHandler.
    template <typename CellIterator>
    T &
    operator[](const CellIterator &cell) const
    {
      return *objects[cell->active_fe_index()];
    }

  private:
    std::vector<std::unique_ptr<T>> objects;
  };
} // namespace stickslip

#endif
