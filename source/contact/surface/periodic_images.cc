#include <stickslip/contact/surface/periodic_images.h>

#include <stickslip/base/in_space.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// Motions and places that differ by less, as a part of the period, are the
    /// same.
    constexpr double same = 1e-6;

    /// Periods to each side of a shift.
    constexpr int n_periods = 5;



    bool
    are_same(const PeriodicMotion &a,
             const PeriodicMotion &b,
             const double          size)
    {
      return (a.Q - b.Q).norm() < same && (a.c - b.c).norm() < same * size;
    }
  } // namespace



  template <int dim>
  PeriodicImages<dim>::PeriodicImages(
    const std::vector<PeriodicBoundary> &boundaries,
    const PeriodicNodes<dim>            &periodic_nodes,
    const MPI_Comm                      &communicator)
    : communicator(communicator)
  {
    for (const PeriodicBoundary &boundary : boundaries)
      {
        largest_distance = std::max(largest_distance, boundary.distance);
        const PeriodicMotion &motion = boundary.motion;
        auto                  known  = std::find_if(
          generators.begin(), generators.end(), [&](const Generator &other) {
            return are_same(motion, other.motion, boundary.distance) ||
                   are_same(motion.inverse(), other.motion, boundary.distance);
          });
        if (known == generators.end())
          {
            Generator generator;
            generator.motion = motion;
            generator.axis   = boundary.axis;
            generator.centre = boundary.centre;
            generator.order  = boundary.order;
            generator.lowest = boundary.is_cyclic() ? 0 : -n_periods;
            generator.n_powers =
              boundary.is_cyclic() ? boundary.order : 2 * n_periods + 1;
            has_rotations = has_rotations || boundary.is_cyclic();
            known         = generators.insert(generators.end(), generator);
          }
        known->bodies.insert(boundary.body);
      }

    // all products of powers, the powers of zero first
    powers  = {{}};
    motions = {PeriodicMotion()};
    for (const Generator &generator : generators)
      {
        std::vector<std::vector<int>> more_powers;
        std::vector<PeriodicMotion>   more_motions;
        std::vector<int>              of_generator;
        for (int p = 0; p < generator.lowest + generator.n_powers; ++p)
          of_generator.push_back(p);
        for (int p = -1; p >= generator.lowest; --p)
          of_generator.push_back(p);
        for (const int p : of_generator)
          {
            const PeriodicMotion one =
              p < 0 ? generator.motion.inverse() : generator.motion;
            PeriodicMotion motion;
            for (int i = 0; i < std::abs(p); ++i)
              motion = one.after(motion);
            for (unsigned int i = 0; i < motions.size(); ++i)
              {
                more_powers.push_back(powers[i]);
                more_powers.back().push_back(p);
                more_motions.push_back(motion.after(motions[i]));
              }
          }
        powers.swap(more_powers);
        motions.swap(more_motions);
      }

    for (const auto &[first, image] : periodic_nodes.images())
      {
        nodes[first] = {image.original, image_by(image.motion)};
        for (unsigned int c = 0; c < dim; ++c)
          originals.insert(image.original + c);
      }
  }



  template <int dim>
  unsigned int
  PeriodicImages<dim>::image_by(const PeriodicMotion &motion) const
  {
    const auto found =
      std::find_if(motions.begin(), motions.end(), [&](const auto &other) {
        return are_same(motion, other, largest_distance);
      });
    AssertThrow(found != motions.end(), ExcInternalError());
    return std::distance(motions.begin(), found);
  }



  template <int dim>
  std::optional<unsigned int>
  PeriodicImages<dim>::number_of(const std::vector<int> &power) const
  {
    std::vector<int> within(power);
    for (unsigned int g = 0; g < generators.size(); ++g)
      if (generators[g].order > 0)
        {
          const int n = generators[g].order;
          within[g]   = (power[g] % n + n) % n;
        }
    const auto found = std::find(powers.begin(), powers.end(), within);
    if (found == powers.end())
      return {};
    return std::distance(powers.begin(), found);
  }



  template <int dim>
  std::optional<unsigned int>
  PeriodicImages<dim>::after(const unsigned int second,
                             const unsigned int first) const
  {
    std::vector<int> sum(powers[first]);
    for (unsigned int g = 0; g < sum.size(); ++g)
      sum[g] += powers[second][g];
    return number_of(sum);
  }



  template <int dim>
  unsigned int
  PeriodicImages<dim>::inverse(const unsigned int image) const
  {
    std::vector<int> negative(powers[image]);
    for (int &power : negative)
      power = -power;
    return *number_of(negative);
  }



  template <int dim>
  bool
  PeriodicImages<dim>::has_room(
    const Generator                       &generator,
    const std::vector<CollectedFace<dim>> &faces) const
  {
    // along the shift, or around the axis from where the middle is
    const auto places = [&](const auto &visit) {
      for (const auto &entry : faces)
        if (entry.is_owned())
          for (const auto &X : entry.face.undeformed_nodes())
            visit(in_space<dim>(X) - generator.centre);
    };
    Tensor<1, 3> sum;
    places([&](const Tensor<1, 3> &r) { sum += r; });
    for (unsigned int d = 0; d < 3; ++d)
      sum[d] = Utilities::MPI::sum(sum[d], communicator);
    const bool   turns = generator.order > 0;
    const double period =
      turns ? 2. * numbers::PI / generator.order : generator.motion.c.norm();
    const Tensor<1, 3> first  = turns
                                  ? sum - (sum * generator.axis) * generator.axis
                                  : generator.motion.c / period;
    const Tensor<1, 3> across = cross_product_3d(generator.axis, first);
    double             low = std::numeric_limits<double>::max(), high = -low;
    places([&](const Tensor<1, 3> &r) {
      const double place =
        turns ? std::atan2(r * across, r * first) : r * first;
      low  = std::min(low, place);
      high = std::max(high, place);
    });
    low  = Utilities::MPI::min(low, communicator);
    high = Utilities::MPI::max(high, communicator);
    return high - low < period * (1. + same);
  }



  template <int dim>
  std::vector<unsigned int>
  PeriodicImages<dim>::images_of(
    const unsigned int                     body,
    const std::vector<CollectedFace<dim>> &faces) const
  {
    std::vector<bool> repeats;
    for (const Generator &generator : generators)
      repeats.push_back(generator.bodies.count(body) > 0 ||
                        has_room(generator, faces));
    std::vector<unsigned int> images;
    for (unsigned int i = 1; i < motions.size(); ++i)
      {
        bool is_one = true;
        for (unsigned int g = 0; g < generators.size(); ++g)
          is_one = is_one && (repeats[g] || powers[i][g] == 0);
        if (is_one)
          images.push_back(i);
      }
    return images;
  }



  template <int dim>
  void
  PeriodicImages<dim>::check_slave(
    const std::string                     &path,
    const unsigned int                     master,
    const unsigned int                     slave,
    const std::vector<CollectedFace<dim>> &faces) const
  {
    for (const Generator &generator : generators)
      if (generator.bodies.count(master) > 0 &&
          generator.bodies.count(slave) == 0 && !has_room(generator, faces))
        throw UserError("'" + path +
                        "': periodic boundaries or cyclic symmetry cut the "
                        "master, but not the slave, which has no room between "
                        "its images. Cut the slave in the same way.");
  }



  template <int dim>
  void
  PeriodicImages<dim>::make_image(const unsigned int j,
                                  const unsigned int image,
                                  SurfaceFace<dim>  &face) const
  {
    face.set_image(j,
                   image,
                   motions[image].template rotation_matrix<dim>(),
                   has_rotations);
  }



  template <int dim>
  std::optional<SurfaceFace<dim>>
  PeriodicImages<dim>::image_of(const SurfaceFace<dim> &face,
                                const unsigned int      image) const
  {
    SurfaceFace<dim> result(face);
    result.id.image = image;
    for (unsigned int j = 0; j < face.n_stencil_nodes(); ++j)
      {
        const auto there = after(image, face.name(j).second);
        if (!there)
          return {};
        make_image(j, *there, result);
        result.reference_positions[j] = Point<dim>(
          motions[image](Tensor<1, dim>(face.reference_positions[j])));
      }
    return result;
  }



  template <int dim>
  types::global_dof_index
  PeriodicImages<dim>::original(const types::global_dof_index first) const
  {
    const auto found = nodes.find(first);
    return found == nodes.end() ? first : found->second.first;
  }



  template <int dim>
  void
  PeriodicImages<dim>::name_nodes(std::vector<CollectedFace<dim>> &faces) const
  {
    if (generators.empty())
      return;
    std::map<types::global_dof_index, std::set<unsigned int>> places;
    for (auto &entry : faces)
      for (unsigned int j = 0; j < entry.face.n_nodes; ++j)
        {
          SurfaceFace<dim> &face  = entry.face;
          const auto        found = nodes.find(face.dofs[j * dim]);
          if (found != nodes.end())
            {
              const auto [original, image] = found->second;
              for (unsigned int c = 0; c < dim; ++c)
                face.dofs[j * dim + c] = original + c;
              make_image(j, image, face);
            }
          if (originals.count(face.dofs[j * dim]) > 0)
            places[face.dofs[j * dim]].insert(face.name(j).second);
        }

    std::vector<CollectedFace<dim>> added;
    for (const auto &entry : faces)
      {
        std::set<unsigned int> images;
        for (unsigned int j = 0; j < entry.face.n_nodes; ++j)
          {
            const auto node = places.find(entry.face.dofs[j * dim]);
            if (node != places.end())
              for (const unsigned int place : node->second)
                if (const auto image =
                      after(place, inverse(entry.face.name(j).second)))
                  images.insert(*image);
          }
        images.erase(0);
        for (const unsigned int image : images)
          if (const auto face = image_of(entry.face, image))
            added.push_back({*face, entry.cell, entry.face_no});
      }
    faces.insert(faces.end(), added.begin(), added.end());
    std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
      return a.face.id < b.face.id;
    });
  }

  template class PeriodicImages<2>;
  template class PeriodicImages<3>;
} // namespace stickslip
