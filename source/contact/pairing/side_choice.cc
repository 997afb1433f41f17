#include <stickslip/contact/pairing/side_choice.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Faces closer than this fraction of their size touch.
    constexpr double touching = 0.1;

    /// Distances are told apart in steps of this fraction of the largest face:
    /// not by roundoff.
    constexpr double distance_step = 0.1;

    /// Mean sizes of faces whose ratio is less are the same.
    constexpr double clearly = 1.2;

    /// Faces with nothing opposite that take a side, counted from those with:
    /// as far as a point looks by default.
    constexpr unsigned int n_layers = 4;



    /// Sets of things of two kinds: whether two of a set are of the same kind
    /// is known.
    class TwoKinds
    {
    public:
      explicit TwoKinds(const unsigned int n)
        : parents(n)
        , differs(n, false)
        , sizes(n, 1)
      {
        std::iota(parents.begin(), parents.end(), 0);
      }

      /// The first of the set of @p i, and whether @p i differs from it.
      std::pair<unsigned int, bool>
      first_of(unsigned int i) const
      {
        bool differs_from_it = false;
        for (; parents[i] != i; i = parents[i])
          differs_from_it = differs_from_it != differs[i];
        return {i, differs_from_it};
      }

      /// Says that two things are the same or @p differ; no effect if the
      /// opposite is known.
      void
      join(const unsigned int a, const unsigned int b, const bool differ)
      {
        const auto [first_a, differs_a] = first_of(a);
        const auto [first_b, differs_b] = first_of(b);
        if (first_a == first_b)
          return;
        const bool         between = (differs_a != differs_b) != differ;
        const unsigned int larger =
          sizes[first_a] < sizes[first_b] ? first_b : first_a;
        const unsigned int other = larger == first_a ? first_b : first_a;
        parents[other]           = larger;
        differs[other]           = between;
        sizes[larger] += sizes[other];
      }

    private:
      std::vector<unsigned int> parents;
      std::vector<bool>         differs; ///< from the parent
      std::vector<unsigned int> sizes;   ///< of the sets, by their first
    };



    using Pairs = std::vector<std::pair<unsigned int, unsigned int>>;



    /// Pairs of faces that share a node.
    Pairs
    neighbours(const std::vector<SidedFace> &faces)
    {
      std::map<types::global_dof_index, std::vector<unsigned int>> around;
      for (unsigned int f = 0; f < faces.size(); ++f)
        for (const auto node : faces[f].nodes)
          around[node].push_back(f);
      Pairs pairs;
      for (const auto &entry : around)
        for (const unsigned int a : entry.second)
          for (const unsigned int b : entry.second)
            if (a < b)
              pairs.emplace_back(a, b);
      std::sort(pairs.begin(), pairs.end());
      pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
      return pairs;
    }



    /// What is known of two faces, and how far apart they are, in steps: that
    /// of closer faces counts before that of others.
    struct Relation
    {
      double       steps  = 0.;
      bool         differ = true;
      unsigned int a = 0, b = 0;

      bool
      operator<(const Relation &other) const
      {
        return std::make_tuple(steps, !differ, a, b) <
               std::make_tuple(other.steps, !other.differ, other.a, other.b);
      }
    };



    /// The choice of sides, with faces by their numbers.
    class SideChoice
    {
    public:
      SideChoice(std::vector<SidedFace>           &faces,
                 const std::vector<OppositeFaces> &opposite)
        : faces(faces)
        , adjacent(neighbours(faces))
        , nearest(faces.size(), std::numeric_limits<double>::infinity())
        , kinds(faces.size() + 1)
        , slaves(faces.size())
      {
        for (const auto &face : faces)
          largest = std::max(largest, face.diameter);
        for (const auto &both : opposite)
          add(both);
        add_neighbours();
        std::sort(relations.begin(), relations.end());
      }

      void
      run()
      {
        join_fixed();
        for (const auto &relation : relations)
          kinds.join(relation.a, relation.b, relation.differ);
        set_sides(slave_kinds());
        for (unsigned int layer = 0; layer < n_layers; ++layer)
          spread();
      }

    private:
      std::vector<SidedFace> &faces;
      const Pairs             adjacent;
      std::vector<double>     nearest; ///< distance of what is opposite
      std::vector<Relation>   relations;
      TwoKinds                kinds;
      const unsigned int      slaves; ///< stands for all that is slave
      double                  largest = 0.;

      double
      steps(const double distance) const
      {
        return std::floor(distance / (distance_step * largest));
      }

      unsigned int
      number_of(const FaceId &id) const
      {
        return std::lower_bound(faces.begin(),
                                faces.end(),
                                id,
                                [](const SidedFace &face, const FaceId &name) {
                                  return face.id < name;
                                }) -
               faces.begin();
      }

      void
      add(const OppositeFaces &both)
      {
        const unsigned int a = number_of(both.a), b = number_of(both.b);
        relations.push_back(
          {steps(both.distance), true, std::min(a, b), std::max(a, b)});
        nearest[a] = std::min(nearest[a], both.distance);
        nearest[b] = std::min(nearest[b], both.distance);
      }

      bool
      has_opposite(const unsigned int f) const
      {
        return std::isfinite(nearest[f]);
      }

      bool
      is_fixed(const unsigned int f) const
      {
        return !faces[f].may_be_slave || !faces[f].may_be_master;
      }

      void
      add_neighbours()
      {
        for (const auto &[a, b] : adjacent)
          if (has_opposite(a) && has_opposite(b))
            relations.push_back(
              {steps(std::max(nearest[a], nearest[b])), false, a, b});
      }

      /// Faces that have one side by name, and those that touch.
      void
      join_fixed()
      {
        for (unsigned int f = 0; f < faces.size(); ++f)
          if (is_fixed(f))
            kinds.join(f, slaves, !faces[f].may_be_slave);
        for (unsigned int f = 0; f < faces.size(); ++f)
          if (!is_fixed(f) && faces[f].side != Side::neither &&
              nearest[f] < touching * faces[f].diameter)
            kinds.join(f, slaves, faces[f].side == Side::master);
      }

      /// What speaks for one of the two kinds of a set being slave.
      struct Votes
      {
        double n_before[2]   = {0., 0.}; ///< faces that were slave
        double n[2]          = {0., 0.};
        double sizes[2]      = {0., 0.};
        bool   kind_of_first = false; ///< of the first face
        bool   is_new        = true;
      };

      static bool
      slave_kind(const Votes &votes)
      {
        if (votes.n_before[0] != votes.n_before[1])
          return votes.n_before[1] > votes.n_before[0];
        if (votes.n[0] > 0. && votes.n[1] > 0.)
          {
            const double mean[2] = {votes.sizes[0] / votes.n[0],
                                    votes.sizes[1] / votes.n[1]};
            if (std::max(mean[0], mean[1]) >
                clearly * std::min(mean[0], mean[1]))
              return mean[1] < mean[0];
          }
        return votes.kind_of_first;
      }

      /// Which kind of each set is slave, by the first of the set.
      std::map<unsigned int, bool>
      slave_kinds() const
      {
        std::map<unsigned int, Votes> votes;
        for (unsigned int f = 0; f < faces.size(); ++f)
          if (has_opposite(f))
            {
              const auto [set, kind] = kinds.first_of(f);
              Votes &of_set          = votes[set];
              if (of_set.is_new)
                of_set.kind_of_first = kind;
              of_set.is_new = false;
              of_set.n[kind] += 1.;
              of_set.sizes[kind] += faces[f].diameter;
              if (faces[f].side != Side::neither)
                of_set.n_before[faces[f].side == Side::slave ? kind : !kind] +=
                  1.;
            }
        std::map<unsigned int, bool> result;
        for (const auto &[set, of_set] : votes)
          result[set] = slave_kind(of_set);
        const auto [set, kind] = kinds.first_of(slaves);
        result[set]            = kind;
        return result;
      }

      void
      set_sides(const std::map<unsigned int, bool> &slave_kinds)
      {
        for (unsigned int f = 0; f < faces.size(); ++f)
          {
            const auto [set, kind] = kinds.first_of(f);
            faces[f].side          = Side::neither;
            if (has_opposite(f) || is_fixed(f))
              faces[f].side =
                slave_kinds.at(set) == kind ? Side::slave : Side::master;
          }
      }

      /// Faces with neighbours of one side take it.
      void
      spread()
      {
        std::vector<bool> beside_slave(faces.size()),
          beside_master(faces.size());
        const auto see = [&](const unsigned int f, const Side side) {
          beside_slave[f]  = beside_slave[f] || side == Side::slave;
          beside_master[f] = beside_master[f] || side == Side::master;
        };
        for (const auto &[a, b] : adjacent)
          {
            see(a, faces[b].side);
            see(b, faces[a].side);
          }
        for (unsigned int f = 0; f < faces.size(); ++f)
          if (faces[f].side == Side::neither &&
              beside_slave[f] != beside_master[f])
            faces[f].side = beside_slave[f] ? Side::slave : Side::master;
      }
    };
  } // namespace



  void
  choose_sides(std::vector<SidedFace>           &faces,
               const std::vector<OppositeFaces> &opposite)
  {
    SideChoice(faces, opposite).run();
  }
} // namespace stickslip
