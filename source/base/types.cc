#include <stickslip/base/types.h>

namespace stickslip
{
  namespace LA
  {
    void
    AlgebraicMultigrid::initialize(const SparseMatrix &matrix,
                                   const unsigned int  n_components,
                                   const unsigned int  n_vectors,
                                   const double       *near_null_space)
    {
      Teuchos::ParameterList list;
      list.set("ML output", 0);
      list.set("max levels", 10);
      list.set("increasing or decreasing", "increasing");
      list.set("prec type", "MGV");
      list.set("PDE equations", static_cast<int>(n_components));
      list.set("aggregation: type", "Uncoupled");
      list.set("aggregation: threshold", 0.);
      list.set("aggregation: damping factor", 4. / 3.);
      list.set("eigen-analysis: type", "cg");
      list.set("smoother: type", "Gauss-Seidel");
      // forwards before, backwards after: as symmetric as symmetric sweeps,
      // at half the price of a cycle and far from twice as many cycles
      list.set("smoother: Gauss-Seidel efficient symmetric", true);
      list.set("smoother: sweeps", 2);
      list.set("smoother: damping factor", 1.);
      list.set("smoother: pre or post", "both");
      list.set("coarse: type", "Amesos-KLU");
      list.set("coarse: max size", 1000);
      if (n_vectors > 0)
        {
          list.set("null space: type", "pre-computed");
          list.set("null space: dimension", static_cast<int>(n_vectors));
          // ML only reads them
          list.set("null space: vectors",
                   const_cast<double *>(near_null_space));
          list.set("null space: add default vectors", false);
        }
      hierarchy.initialize(matrix, list);
    }
  } // namespace LA
} // namespace stickslip
