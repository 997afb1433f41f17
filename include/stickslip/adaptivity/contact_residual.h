#ifndef stickslip_adaptivity_contact_residual_h
#define stickslip_adaptivity_contact_residual_h

#include <stickslip/problem/contact_problem.h>

#include <deal.II/base/tensor.h>

#include <deal.II/lac/vector.h>

#include <map>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * What contact does to the faces of both surfaces, in a form that can be
   * compared with the stresses of their cells: on each face the traction per
   * undeformed area, and on slave faces how far the contact law is from being
   * satisfied at every place.
   *
   * Tractions of the slave are those of the contact points; on the master their
   * opposites, at the places opposite. On either face they are projected (L2)
   * to the shape functions of the face, so that a face that is covered in part
   * has a part of them. With other rules than segments those of the master are
   * forces on its nodes over the areas of the nodes.
   *
   * The law holds for averages around nodes, or at contact points. What is left
   * between them is, with the pressure p >= 0, gap g, friction threshold s,
   * tangential traction t_t on the slave and slip u_t of the step,
   *
   *   int p |g| + k min(g, 0)^2 + (s |u_t| + t_t . u_t)
   *     + (max(|t_t| - s, 0)^2 + max(-p, 0)^2) / k,
   *
   * an energy: complementarity and penetration, which a solution of
   * Signorini's problem has none of, the same for friction (t_t is opposite to
   * the slip where |t_t| = s), and tractions outside of the cone. k is the
   * stiffness of the contact, modulus over cell size, as it is for h^1/2 norms.
   * (Terms of Hild, Nicaise, Numer. Math. 101, 2005, Hild, Lleras, SIAM J.
   * Numer. Anal. 47, 2009, and Krause, Veeser, Walloth, Numer. Math. 130, 2015;
   * Wohlmuth, Acta Numerica 20, 2011, on multipliers.) Surfaces that cannot
   * part have none of these.
   */
  template <int dim>
  class ContactResidual
  {
  public:
    /// Of the present state. Collective.
    explicit ContactResidual(ContactProblem<dim> &problem);

    using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

    /// Tractions at the nodes of a face of a cell of this rank, by the number
    /// of the node's shape function in the scalar element; null if the face
    /// touches nothing.
    const std::map<unsigned int, Tensor<1, dim>> *
    tractions_on(const CellIterator &cell, const unsigned int face) const;

    /// What is left of the contact law, squares by active cell index of the
    /// slave's cells.
    const Vector<double> &
    law_errors() const
    {
      return errors;
    }

  private:
    using FaceKey = std::pair<unsigned int, unsigned int>;

    std::map<FaceKey, std::map<unsigned int, Tensor<1, dim>>> tractions;
    Vector<double>                                            errors;

    /// Takes forces on the nodes of the faces, int t N_j.
    void
    take_forces(const ContactProblem<dim> &problem,
                const CellIterator        &cell,
                const unsigned int         face,
                const std::vector<double> &forces);
  };
} // namespace stickslip

#endif
