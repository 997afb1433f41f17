#ifndef stickslip_mesh_file_abaqus_model_h
#define stickslip_mesh_file_abaqus_model_h

#include <stickslip/mesh/file/mesh_file.h>
#include <stickslip/mesh/file/point_numbers.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace stickslip
{
  /// A set of elements or nodes as the file has it.
  struct AbaqusSet
  {
    std::string                      name;
    std::string                      instance; ///< empty: where the set stands
    std::size_t                      line           = 0;
    bool                             is_internal    = false;
    bool                             is_of_elements = true;
    bool                             has_number = false; ///< see read_abaqus()
    unsigned int                     dimension  = 0;     ///< of what has_number
    std::vector<long>                labels;
    std::vector<std::array<long, 3>> ranges; ///< first, last, increment
    std::vector<std::string>         names;  ///< of other sets
  };

  /// One entry of a surface: elements and, maybe, one of their sides.
  struct AbaqusSide
  {
    std::string elements; ///< a set or a label
    std::string side;     ///< upper case; empty: the free sides
    std::size_t line = 0;
  };

  struct AbaqusSurface
  {
    std::string             name;
    bool                    is_of_nodes = false;
    std::vector<AbaqusSide> sides;
  };

  struct AbaqusElement
  {
    long                      label;
    unsigned int              type;
    std::vector<unsigned int> nodes; ///< indices of the part's points
  };

  /// In AbaqusPart::element_numbers: of a type that is not known.
  constexpr std::size_t skipped_element = static_cast<std::size_t>(-1);

  /// A part, or what stands outside of parts: the flat model, the assembly.
  struct AbaqusPart
  {
    std::vector<Point<3>>                 points;
    PointNumbers                          point_numbers;
    std::vector<long>                     point_labels;
    std::vector<AbaqusElement>            elements;
    std::unordered_map<long, std::size_t> element_numbers;
    std::vector<AbaqusSet>                sets;
    std::vector<AbaqusSurface>            surfaces;
  };

  /// Where an instance of a part is put.
  struct AbaqusPlace
  {
    Tensor<1, 3>        translation;
    std::vector<double> rotation; ///< two points of the axis, angle in degrees

    Point<3>
    operator()(const Point<3> &point) const;
  };



  /**
   * Puts instances of parts into a MeshFile and finds out what their sets and
   * surfaces contain.
   */
  class AbaqusModel
  {
  public:
    /// Decides on the numbers of all groups. Before the first add().
    void
    number_groups(const std::vector<std::shared_ptr<const AbaqusPart>> &parts);

    /// Appends the points and elements of @p part and its sets and surfaces.
    /// @p instance is "" for what stands outside of parts: it comes last, and
    /// its sets may refer to all instances.
    void
    add(const std::shared_ptr<const AbaqusPart> &part,
        const std::string                       &instance,
        const AbaqusPlace                       &place);

    MeshFile file;

  private:
    using Indices = std::vector<std::size_t>;

    struct Instance
    {
      std::shared_ptr<const AbaqusPart> part;
      std::size_t                       first_point, first_element;
    };

    /// Sets that are known where a part's sets stand, by upper-case name.
    struct Scope
    {
      const Instance                *own;
      std::map<std::string, Indices> sets_of_elements, sets_of_points;

      std::map<std::string, Indices> &
      sets(const bool of_elements)
      {
        return of_elements ? sets_of_elements : sets_of_points;
      }

      const std::map<std::string, Indices> &
      sets(const bool of_elements) const
      {
        return of_elements ? sets_of_elements : sets_of_points;
      }
    };

    /// The index of a label in an instance; false if there is none.
    static bool
    find_label(const long      label,
               const bool      is_element,
               const Instance &instance,
               std::size_t    &index);

    /// The members of a set or the one of a label, also "instance.set" and
    /// "instance.label"; false if there is no such thing.
    bool
    find_members(const std::string &text,
                 const bool         is_element,
                 const Scope       &scope,
                 Indices           &members) const;

    const Instance &
    instance_of(const AbaqusSet &set, const Scope &scope) const;

    Indices
    members_of(const AbaqusSet &set, const Scope &scope) const;

    void
    add_elements(const Instance &instance, const std::string &name);

    void
    add_sets(const AbaqusPart &part, Scope &scope);

    void
    add_to_groups(const AbaqusSet &set, const Indices &elements);

    void
    add_surface(const AbaqusSurface &surface, const Scope &scope);

    void
    add_side(const std::size_t  element,
             const AbaqusSide  &side,
             const std::string &surface);

    void
    add_face(const std::vector<unsigned int> &nodes,
             const std::string               &surface);

    bool
    is_free(std::vector<unsigned int> nodes);

    /// The group of @p name with the number that it has, if it has one.
    unsigned int
    group(const unsigned int dimension, const std::string &name);

    std::map<std::string, Instance> instances; ///< by upper-case name
    std::map<std::string, Scope>    scopes;
    std::map<std::pair<unsigned int, std::string>, int> numbers_by_name;

    /// How many elements have a side with these (sorted) vertices.
    std::map<std::vector<unsigned int>, unsigned int> n_elements_at;
    std::size_t                                       n_counted_elements = 0;
  };
} // namespace stickslip

#endif
