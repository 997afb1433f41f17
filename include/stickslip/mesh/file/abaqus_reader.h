#ifndef stickslip_mesh_file_abaqus_reader_h
#define stickslip_mesh_file_abaqus_reader_h

#include <stickslip/mesh/file/abaqus_lines.h>
#include <stickslip/mesh/file/abaqus_model.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip
{
  /// Reads the lines of an Abaqus file into a model; see read_abaqus().
  class AbaqusReader
  {
  public:
    explicit AbaqusReader(const std::string_view text)
      : lines(text)
    {}

    MeshFile
    read();

  private:
    /// What the data lines that follow mean.
    enum class Mode
    {
      skip,
      nodes,
      elements,
      set,
      surface,
      instance
    };

    void
    read_keyword();

    void
    begin_instance();

    void
    begin_elements();

    void
    begin_set(const bool is_of_elements, const std::string &name);

    void
    begin_surface();

    void
    read_data();

    void
    read_node();

    void
    read_element();

    void
    read_members();

    void
    read_side();

    void
    read_place();

    void
    add_element(const long label);

    void
    check_is_complete() const;

    std::string
    required(const std::string &option) const;

    AbaqusLines lines;
    AbaqusModel model;
    Mode        mode = Mode::skip;

    std::shared_ptr<AbaqusPart> outside = std::make_shared<AbaqusPart>();
    std::shared_ptr<AbaqusPart> part    = outside; ///< in work
    std::map<std::string, std::shared_ptr<AbaqusPart>> parts;

    struct PlacedPart
    {
      std::shared_ptr<AbaqusPart> part;
      std::string                 name;
      AbaqusPlace                 place;
      unsigned int                n_lines = 0;
    };
    std::vector<PlacedPart> instances;

    int                                type = -1; ///< of *ELEMENT
    std::string                        type_name, set_name;
    bool                               generates = false;
    std::vector<long>                  element; ///< label and nodes so far
    std::size_t                        element_line = 0;
    std::map<std::string, std::size_t> unknown_types;
    bool                               has_nodes = false;
  };
} // namespace stickslip

#endif
