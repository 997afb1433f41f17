#include <stickslip/contact/pairing/face_boxes.h>

#include <algorithm>
#include <utility>

namespace stickslip
{
  template <int dim>
  BoundingBox<dim>
  box_of(const std::vector<Tensor<1, dim>> &positions,
         const unsigned int                 n,
         const double                       relative_margin)
  {
    Point<dim> low(positions[0]), high(positions[0]);
    for (unsigned int j = 1; j < n; ++j)
      for (unsigned int c = 0; c < dim; ++c)
        {
          low[c]  = std::min(low[c], positions[j][c]);
          high[c] = std::max(high[c], positions[j][c]);
        }
    // curved faces may bulge out of the box of their nodes
    const double margin = relative_margin * low.distance(high);
    for (unsigned int c = 0; c < dim; ++c)
      {
        low[c] -= margin;
        high[c] += margin;
      }
    return BoundingBox<dim>(std::make_pair(low, high));
  }



  template <int dim>
  BoundingBox<dim>
  enlarged(const BoundingBox<dim> &box, const double amount)
  {
    auto points = box.get_boundary_points();
    for (unsigned int c = 0; c < dim; ++c)
      {
        points.first[c] -= amount;
        points.second[c] += amount;
      }
    return BoundingBox<dim>(points);
  }



  template <int dim>
  std::vector<BoundingBox<dim>>
  summarize(std::vector<BoundingBox<dim>> boxes, const unsigned int at_most)
  {
    if (boxes.size() <= 1 || at_most <= 1)
      {
        if (boxes.size() > 1)
          {
            BoundingBox<dim> all = boxes[0];
            for (const auto &box : boxes)
              all.merge_with(box);
            boxes = {all};
          }
        return boxes;
      }
    Point<dim> low = boxes[0].center(), high = low;
    for (const auto &box : boxes)
      for (unsigned int c = 0; c < dim; ++c)
        {
          low[c]  = std::min(low[c], box.center()[c]);
          high[c] = std::max(high[c], box.center()[c]);
        }
    unsigned int longest = 0;
    for (unsigned int c = 1; c < dim; ++c)
      if (high[c] - low[c] > high[longest] - low[longest])
        longest = c;
    const auto middle = boxes.begin() + boxes.size() / 2;
    std::nth_element(boxes.begin(),
                     middle,
                     boxes.end(),
                     [longest](const auto &a, const auto &b) {
                       return a.center()[longest] < b.center()[longest];
                     });
    using Boxes  = std::vector<BoundingBox<dim>>;
    Boxes result = summarize<dim>(Boxes(boxes.begin(), middle), at_most / 2);
    for (const auto &box :
         summarize<dim>(Boxes(middle, boxes.end()), at_most / 2))
      result.push_back(box);
    return result;
  }

  template BoundingBox<2>
  box_of(const std::vector<Tensor<1, 2>> &, const unsigned int, const double);
  template BoundingBox<3>
  box_of(const std::vector<Tensor<1, 3>> &, const unsigned int, const double);
  template BoundingBox<2>
  enlarged(const BoundingBox<2> &, const double);
  template BoundingBox<3>
  enlarged(const BoundingBox<3> &, const double);
  template std::vector<BoundingBox<2>>
  summarize(std::vector<BoundingBox<2>>, const unsigned int);
  template std::vector<BoundingBox<3>>
  summarize(std::vector<BoundingBox<3>>, const unsigned int);
} // namespace stickslip
