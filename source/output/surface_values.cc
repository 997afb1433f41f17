#include <stickslip/output/surface_values.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/reference_cells.h>

#include <stickslip/contact/surface/face_shape.h>
#include <stickslip/contact/surface/surface_face.h>

#include <stickslip/output/contact_output.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// A point this far from a face (in its size) still belongs to it.
    constexpr double largest_distance = 0.05;

    /// Faces whose distances differ by less are equally near.
    constexpr double same_distance = 1e-8;

    constexpr double far = std::numeric_limits<double>::max();



    template <int dim>
    struct Place
    {
      double         distance = far; ///< over the size of the face
      Point<dim - 1> xi;
    };



    template <int dim>
    Point<dim - 1>
    project_to_face(const FaceShape<dim> &shape, Point<dim - 1> xi)
    {
      if constexpr (dim == 3)
        return project_to_unit_cell(shape.reference_cell(), xi);
      xi[0] = std::clamp(xi[0], 0., 1.);
      return xi;
    }



    /// The nearest place on a face (Gauss-Newton, clamped to the face).
    template <int dim>
    Place<dim>
    nearest_place(const FaceShape<dim>          &shape,
                  const std::vector<Point<dim>> &reference_positions,
                  const Tensor<1, dim>          &position)
    {
      const std::vector<Tensor<1, dim>> nodes(reference_positions.begin(),
                                              reference_positions.end());
      const Tensor<1, dim>              centre =
        interpolate<dim>(shape.at_centre().value, nodes);
      double radius = 0.;
      for (const Tensor<1, dim> &node : nodes)
        radius = std::max(radius, (node - centre).norm());
      Place<dim> place;
      if ((position - centre).norm() > 1.5 * radius)
        return place;

      FaceShapeValues<dim> values;
      Tensor<1, dim>       rest;
      place.xi = shape.centre();
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          shape.evaluate(place.xi, values);
          rest = position - interpolate<dim>(values.value, nodes);
          const auto tangents = surface_tangents<dim>(values.gradient, nodes);
          Tensor<2, dim - 1> metric;
          Tensor<1, dim - 1> right_hand_side;
          for (unsigned int a = 0; a < dim - 1; ++a)
            {
              right_hand_side[a] = tangents[a] * rest;
              for (unsigned int b = 0; b < dim - 1; ++b)
                metric[a][b] = tangents[a] * tangents[b];
            }
          const Tensor<1, dim - 1> step = invert(metric) * right_hand_side;
          const Point<dim - 1>     old  = place.xi;
          place.xi = project_to_face<dim>(shape, place.xi + step);
          if (place.xi.distance(old) < 1e-14)
            break;
        }
      place.distance = rest.norm() / (2. * radius);
      return place;
    }



    /// One point and what a face has there, as numbers that can be summed.
    template <int dim>
    void
    add_values(const FaceShape<dim>         &shape,
               const ContactFaceResult<dim> &face,
               const Point<dim - 1>         &xi,
               double                       *sums)
    {
      const ContactNodalFields<dim> fields(face);
      std::vector<double>           N;
      shape.evaluate_values(xi, N);
      sums[0] += 1.;
      for (unsigned int j = 0; j < N.size(); ++j)
        {
          sums[1] -= N[j] * face.lambda_n[j];
          sums[2] += N[j] * fields.gap[j];
          for (unsigned int d = 0; d < dim; ++d)
            {
              sums[3 + d] += N[j] * face.displacements[j][d];
              sums[3 + dim + d] += N[j] * fields.tangential_traction[j][d];
            }
        }
    }



    template <int dim>
    void
    refuse(const SurfacePoint<dim> &point)
    {
      std::ostringstream position;
      position << point.reference_position;
      throw UserError(point.path + ": the point (" + position.str() +
                      ") is not on the slave surface of the contact pair, "
                      "in its undeformed mesh.");
    }
  } // namespace



  template <int dim>
  std::vector<SurfaceValues<dim>>
  values_on_surface(const std::vector<SurfacePoint<dim>>      &points,
                    const std::vector<ContactFaceResult<dim>> &faces,
                    const MPI_Comm                             communicator)
  {
    std::vector<SurfaceValues<dim>> result(points.size());
    if (points.empty())
      return result;
    // of one kind on the surface of a pair
    std::map<unsigned int, FaceShape<dim>> shape_of_pair;
    for (const ContactFaceResult<dim> &face : faces)
      shape_of_pair.try_emplace(face.pair, face.degree, face.cell);

    std::vector<std::vector<Place<dim>>> places(points.size());
    std::vector<double>                  nearest(points.size(), far);
    for (unsigned int p = 0; p < points.size(); ++p)
      for (const ContactFaceResult<dim> &face : faces)
        {
          places[p].push_back(face.pair == points[p].pair
                                ? nearest_place(shape_of_pair.at(face.pair),
                                                face.reference_positions,
                                                points[p].reference_position)
                                : Place<dim>());
          nearest[p] = std::min(nearest[p], places[p].back().distance);
        }
    Utilities::MPI::min(nearest, communicator, nearest);

    constexpr unsigned int n_sums = 3 + 2 * dim;
    std::vector<double>    sums(n_sums * points.size(), 0.);
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        if (nearest[p] > largest_distance)
          refuse(points[p]);
        for (unsigned int f = 0; f < faces.size(); ++f)
          if (places[p][f].distance <= nearest[p] + same_distance)
            add_values(shape_of_pair.at(faces[f].pair),
                       faces[f],
                       places[p][f].xi,
                       &sums[n_sums * p]);
      }
    Utilities::MPI::sum(sums, communicator, sums);
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const double *values = &sums[n_sums * p];
        result[p].pressure   = values[1] / values[0];
        result[p].gap        = values[2] / values[0];
        for (unsigned int d = 0; d < dim; ++d)
          {
            result[p].displacement[d]        = values[3 + d] / values[0];
            result[p].tangential_traction[d] = values[3 + dim + d] / values[0];
          }
      }
    return result;
  }

  template std::vector<SurfaceValues<2>>
  values_on_surface(const std::vector<SurfacePoint<2>> &,
                    const std::vector<ContactFaceResult<2>> &,
                    const MPI_Comm);
  template std::vector<SurfaceValues<3>>
  values_on_surface(const std::vector<SurfacePoint<3>> &,
                    const std::vector<ContactFaceResult<3>> &,
                    const MPI_Comm);
} // namespace stickslip
