#include <stickslip/solid/held_images.h>

#include <stickslip/solid/displacement_constraints.h>

#include <deal.II/base/mpi.h>

#include <utility>

namespace stickslip
{
  namespace
  {
    /// Motions of a node and of its image that differ by less, as a part of
    /// what a reference point moves, are alike: see
    /// HeldNode::Row::same_direction().
    constexpr double same_motion = 1e-4;



    /// What is prescribed at an image, for the rank that owns its original.
    template <int dim>
    struct HeldImage
    {
      types::global_dof_index                  original;
      types::global_dof_index                  first_dof;
      Tensor<2, dim>                           Q;
      Tensor<1, dim>                           c;
      Tensor<1, dim>                           position;
      unsigned int                             body;
      double                                   cell_diameter;
      unsigned int                             coupling;
      std::vector<Tensor<1, dim>>              directions;
      std::vector<std::pair<double, unsigned>> values; ///< and conditions

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &original &first_dof &Q &c &position &body &cell_diameter
          &coupling &directions &values;
      }
    };



    /// Of the images that this rank owns: all of those that are held, and the
    /// others if @p all_of_them. By the rank that owns the original.
    template <int dim>
    std::vector<HeldImage<dim>>
    images_of_rank(
      const PeriodicNodes<dim>                               &periodic_nodes,
      const IndexSet                                         &owned,
      const std::map<types::global_dof_index, HeldNode<dim>> &nodes,
      const bool                                              all_of_them)
    {
      std::vector<HeldImage<dim>> result;
      for (const auto &[first_dof, image] : periodic_nodes.images())
        {
          const auto held = nodes.find(first_dof);
          if (!owned.is_element(first_dof) ||
              (held == nodes.end() && !all_of_them))
            continue;
          HeldImage<dim> told{image.original,
                              first_dof,
                              image.motion.template rotation_matrix<dim>(),
                              image.motion(Tensor<1, dim>()),
                              {},
                              0,
                              0.,
                              numbers::invalid_unsigned_int,
                              {},
                              {}};
          if (held != nodes.end())
            {
              const HeldNode<dim> &node = held->second;
              told.position             = node.position;
              told.body                 = node.body;
              told.cell_diameter        = node.cell_diameter;
              told.coupling             = node.coupling;
              for (const auto &row : node.rows)
                {
                  told.directions.push_back(row.direction);
                  told.values.emplace_back(row.value, row.condition);
                }
            }
          result.push_back(told);
        }
      return result;
    }



    /// Those of all ranks whose originals this rank owns.
    template <int dim>
    std::vector<HeldImage<dim>>
    images_of_originals(const std::vector<HeldImage<dim>> &of_rank,
                        const IndexSet                    &owned,
                        const MPI_Comm                     communicator)
    {
      IndexSet originals(owned.size());
      for (const HeldImage<dim> &image : of_rank)
        originals.add_index(image.original);
      originals.compress();
      const std::vector<unsigned int> owners =
        Utilities::MPI::compute_index_owner(owned, originals, communicator);
      std::map<unsigned int, std::vector<HeldImage<dim>>> told;
      for (const HeldImage<dim> &image : of_rank)
        told[owners[originals.index_within_set(image.original)]].push_back(
          image);
      std::vector<HeldImage<dim>> result;
      for (const auto &[rank, images] :
           Utilities::MPI::some_to_some(communicator, told))
        result.insert(result.end(), images.begin(), images.end());
      return result;
    }



    /// Whether the reference point moves both places of a node alike.
    template <int dim>
    bool
    moves_alike(const RigidMotion<dim> &motion,
                const HeldImage<dim>   &image,
                const Point<dim>       &original,
                const double            time)
    {
      const auto arm_of = [&](const Tensor<1, dim> &x) {
        return RigidState<dim>().current_arm(
          Tensor<1, dim>(x - motion.reference_point()));
      };
      const Tensor<1, 3> arm       = arm_of(original);
      const Tensor<1, 3> image_arm = arm_of(image.position);
      const double       length    = arm.norm() + image_arm.norm();
      for (unsigned int k = 0; k < motion.n_components; ++k)
        if (motion.is_free(k))
          {
            Tensor<1, dim> here, there;
            if (k < dim)
              here[k] = there[k] = 1.;
            else
              for (unsigned int d = 0; d < dim; ++d)
                {
                  here[d] = cross_product_3d(motion.rotation_axis(k), arm)[d];
                  there[d] =
                    cross_product_3d(motion.rotation_axis(k), image_arm)[d];
                }
            if ((there - image.Q * here).norm() >
                same_motion * (k < dim ? 1. : length))
              return false;
          }
      const Tensor<1, dim> u = motion.displacement(original, time);
      return (motion.displacement(Point<dim>(image.position), time) -
              image.Q * u)
               .norm() <= same_motion * u.norm() + 2e-5 * image.cell_diameter;
    }



    template <int dim>
    std::string
    coupling_text(const HeldImage<dim>                           &image,
                  const unsigned int                              coupling,
                  const Point<dim>                               &original,
                  const Point<dim>                               &position,
                  const bool                                      is_at_both,
                  const std::vector<PrescribedDisplacement<dim>> &conditions)
    {
      const bool        is_image_held = image.coupling < conditions.size();
      const std::string name =
        conditions[is_image_held ? image.coupling : coupling].name;
      const std::string here  = in_brackets<dim>(original);
      const std::string there = in_brackets<dim>(position);
      const std::string one_node =
        ": periodic boundaries or sides of cyclic symmetry make one node of "
        "the two. ";
      if (is_at_both)
        return "Boundary conditions/" + name + " moves the node " + there +
               " otherwise than " + here + one_node +
               "Leave free only what is the same at both: no rotation of what "
               "is repeated along an axis, and of a sector the translation "
               "along the axis and the rotation about it.";
      return "Boundary conditions/" + name + " holds the node " +
             (is_image_held ? there : here) + ", but not " +
             (is_image_held ? here : there) + one_node +
             "Name boundaries that have both, or leave both out with "
             "'Where'.";
    }



    template <int dim>
    void
    check_coupling(const HeldImage<dim>                           &image,
                   const HeldNode<dim>                            *node,
                   const std::vector<PrescribedDisplacement<dim>> &conditions,
                   const double                                    time,
                   std::string                                    &error)
    {
      const unsigned int coupling =
        node != nullptr ? node->coupling : numbers::invalid_unsigned_int;
      const bool is_same = image.coupling == coupling;
      if (!error.empty() ||
          (is_same && coupling == numbers::invalid_unsigned_int))
        return;
      // an image that nothing holds has not told its position
      const Point<dim> original(node != nullptr ? Tensor<1, dim>(node->position)
                                                : transpose(image.Q) *
                                                    (image.position - image.c));
      const Point<dim> position(image.Q * original + image.c);
      if (!is_same ||
          !moves_alike(conditions[coupling].motion, image, original, time))
        error = coupling_text(
          image, coupling, original, position, is_same, conditions);
    }
  } // namespace



  template <int dim>
  void
  add_rows_of_images(const PeriodicNodes<dim> &periodic_nodes,
                     const IndexSet           &owned,
                     const std::vector<PrescribedDisplacement<dim>> &conditions,
                     const double                                    time,
                     const MPI_Comm communicator,
                     std::map<types::global_dof_index, HeldNode<dim>> &nodes,
                     std::string                                      &error)
  {
    // the same on all ranks
    if (!periodic_nodes.has_boundaries())
      return;
    bool has_couplings = false;
    for (const auto &condition : conditions)
      has_couplings = has_couplings || condition.is_coupling();

    const auto images = images_of_originals(
      images_of_rank(periodic_nodes, owned, nodes, has_couplings),
      owned,
      communicator);
    for (const HeldImage<dim> &image : images)
      {
        const auto known = nodes.find(image.original);
        check_coupling(image,
                       known != nodes.end() ? &known->second : nullptr,
                       conditions,
                       time,
                       error);
      }
    for (const HeldImage<dim> &image : images)
      {
        if (image.directions.empty())
          continue;
        HeldNode<dim> &node = nodes[image.original];
        if (node.rows.empty() && !node.is_coupled())
          {
            for (unsigned int d = 0; d < dim; ++d)
              node.dofs[d] = image.original + d;
            node.position =
              Point<dim>(transpose(image.Q) * (image.position - image.c));
            node.body          = image.body;
            node.cell_diameter = image.cell_diameter;
          }
        for (unsigned int r = 0; r < image.directions.size(); ++r)
          node.rows.push_back(
            {transpose(image.Q) * image.directions[r],
             image.values[r].first,
             image.values[r].second,
             NodeImage<dim>{Point<dim>(image.position), image.Q}});
      }
  }

#define INSTANTIATE(dim)                                \
  template void add_rows_of_images(                     \
    const PeriodicNodes<dim> &,                         \
    const IndexSet &,                                   \
    const std::vector<PrescribedDisplacement<dim>> &,   \
    const double,                                       \
    const MPI_Comm,                                     \
    std::map<types::global_dof_index, HeldNode<dim>> &, \
    std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
