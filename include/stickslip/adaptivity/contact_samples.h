#ifndef stickslip_adaptivity_contact_samples_h
#define stickslip_adaptivity_contact_samples_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <deal.II/distributed/tria_base.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace stickslip
{
  /// A contact point in its present state.
  template <int dim>
  struct SampledPoint
  {
    bool           paired = false;
    bool           closed = false;
    bool           stick  = false;
    Tensor<1, dim> n;              ///< into the master
    Tensor<1, dim> traction;       ///< on the slave, per undeformed slave area
    double         threshold = 0.; ///< of friction [stress]
    double         stiffness = 0.; ///< contact_stiffness() [stress/length]
  };

  /**
   * A place where a slave face and a master face are opposite each other, and
   * the contact point that has a part of it: with segments an integration
   * point of them and a multiplier node, else a contact point.
   */
  template <int dim>
  struct ContactSample
  {
    ContactSample(const SurfaceFace<dim> &slave, const SurfaceFace<dim> &master)
      : slave(slave)
      , master(master)
    {}

    const SurfaceFace<dim> &slave;
    const SurfaceFace<dim> &master;
    std::vector<double>     N_slave;  ///< shape functions of the nodes there
    std::vector<double>     N_master; ///< likewise; of a tool, of its frame
    double weight = 0.; ///< undeformed slave area, times the node's function
    double d_n    = 0.; ///< minus the gap there [length]
    Tensor<1, dim> d_t; ///< slip of the step there
  };

  /**
   * Calls @p visit(pair, point, sample) for all contact points of this rank that
   * are paired, in the present configuration. With segments the function of a
   * node is its shape function, extended to what has no multiplier
   * (MortarFace::extended): the functions of all nodes add up to one. They are
   * not the dual ones, with which multipliers of a smooth pressure oscillate.
   * Not collective.
   */
  template <int dim>
  void
  for_each_sample(ContactAssembler<dim> &contact,
                  const std::function<void(const ContactPair<dim> &,
                                           const SampledPoint<dim> &,
                                           const ContactSample<dim> &)> &visit);



  /// Numbers for faces, whose cells may be on other ranks.
  template <int dim>
  class FaceMessages
  {
  public:
    /// The numbers of @p face, of which there are @p n, zero at first.
    std::vector<double> &
    to(const SurfaceFace<dim> &face, const unsigned int n);

    struct Received
    {
      typename Triangulation<dim>::active_cell_iterator cell;
      unsigned int                                      face;
      std::vector<double> numbers; ///< sum over all senders
    };

    /// Sends them to the owners of the cells. Collective.
    std::vector<Received>
    exchange(const Triangulation<dim> &triangulation) const;

  private:
    /// By owner.
    std::map<unsigned int, std::map<FaceId, std::vector<double>>> messages;
  };
} // namespace stickslip

#endif
