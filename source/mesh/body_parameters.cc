#include <stickslip/mesh/body_parameters.h>
#include <stickslip/mesh/tool_generators.h>

#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/user_error.h>
#include <stickslip/mesh/condition_list.h>

namespace stickslip
{
  namespace
  {
    const char *const condition_variables =
      "x, y, z and id, the id so far (from the generator or the file); 'in "
      "NAME' holds in the group of this name or number. "
      "Later conditions win; each must hold somewhere.";
  }



  void
  BodyParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Generator",
                      generator,
                      "Name of a mesh generator, for instance hyper_rectangle: "
                      "deal.II's GridGenerator functions and our own "
                      "graded_hyper_rectangle, annular_sector, "
                      "graded_annular_sector and, for rigid tools without a "
                      "mesh, tool_plane, tool_cylinder and so on. Give this or "
                      "Mesh file.");
    prm.add_parameter(
      "Arguments",
      arguments,
      "The generator's arguments, separated by ':', the coordinates of a point "
      "by ','. Missing ones at the end get their defaults. Example for "
      "subdivided_hyper_rectangle: 4, 2 : 0, 0 : 2, 1 : true. "
      "graded_hyper_rectangle takes one list of positions per direction, with "
      "|n| cells (and the ratio of the last to the first cell) in between: "
      "0 |2| 5 |10, 0.2| 40 : 0 |4| 10. annular_sector: inner radius : outer "
      "radius : first angle : last angle (degrees) : radial cells : angular "
      "cells, and in 3D : length : axial cells; its boundary ids are 0 inner "
      "arc, 1 outer arc, 2 first angle, 3 last angle, 4 and 5 the ends in z. "
      "graded_annular_sector takes lists of positions of radius, angle and z: "
      "10 |6, 4| 40 : 0 |48| 360 : 0 |2| 10.");
    prm.add_parameter("Mesh file",
                      mesh_file,
                      "A mesh of quadrilaterals or triangles (2D), of "
                      "hexahedra or tetrahedra (3D), of the first or second "
                      "order, from "
                      "Gmsh (.msh), Abaqus (.inp), VTK (.vtk, .vtu) or UCD "
                      "(.ucd, .inp); relative names start at the folder of the "
                      ".prm file. Names of physical groups, sets and surfaces "
                      "are names of boundaries and regions; 'stickslip "
                      "--inspect-mesh FILE' lists them.");
    prm.add_parameter("Mesh group",
                      mesh_groups,
                      "Names or numbers of groups of cells in the mesh file "
                      "(physical volumes of Gmsh, element sets or instances of "
                      "Abaqus) that make this body, separated by commas. Other "
                      "cells of the file may make other bodies. Empty: all "
                      "cells.");
    add_choice(prm,
               "Mesh format",
               mesh_format,
               all_mesh_formats(),
               expert(
                 "Format of the mesh file; automatic goes by the extension "
                 "(.msh, .inp, .vtk, .vtu, .ucd) and, for .inp, the "
                 "contents."));
    prm.add_parameter(
      "Coordinates",
      coordinates,
      "New coordinates of the vertices, \"fx; fy\" or \"fx; fy; fz\", as "
      "expressions of x, y, z, for grading and shaping, after the "
      "Refinements of this body. If these bend the boundary, the sides of "
      "cells are parabolas (Degree = 2), also of cells that are refined "
      "later.");
    prm.add_parameter("Refinements",
                      refinements,
                      "Uniform refinements of this body alone, before the "
                      "bodies are joined: its cells become coarse cells, which "
                      "every rank holds. For large meshes prefer "
                      "'Mesh/Global refinements'.",
                      Patterns::Integer(0, 12));

    prm.add_parameter("Simplices",
                      simplices,
                      "Cuts each quadrilateral into 8 triangles, each "
                      "hexahedron into 24 tetrahedra, after the Refinements of "
                      "this body. Other bodies may be made of the other kind.");

    prm.add_parameter("Scale",
                      scale,
                      "Factor, or one factor per direction.",
                      Patterns::List(Patterns::Double(0.), 1, 3));
    prm.add_parameter("Rotation axis",
                      rotation_axis,
                      "Direction of the axis in 3D (2D: always z).",
                      Patterns::List(Patterns::Double(), 3, 3));
    prm.add_parameter("Rotation angle",
                      rotation_angle,
                      "Degrees, after scaling.");
    prm.add_parameter("Rotation centre",
                      rotation_centre,
                      "A point of the axis, in scaled coordinates.",
                      Patterns::List(Patterns::Double(), 2, 3));
    prm.add_parameter("Translation",
                      translation,
                      "Shift after the rotation.",
                      Patterns::List(Patterns::Double(), 2, 3));

    prm.add_parameter("Boundary ids",
                      boundary_ids,
                      std::string(
                        "Further boundary ids or names, \"id: condition; name: "
                        "condition\", for "
                        "instance \"10: y < 1e-8; side: abs(x - 40) < 1e-6\". "
                        "Conditions are expressions of the face's centre ") +
                        condition_variables);
    prm.add_parameter(
      "Material",
      material,
      "Name of a section of Materials; a rigid body needs none.");
    prm.add_parameter(
      "Material regions",
      material_regions,
      std::string(
        "Other materials in parts of the body, \"name: condition; "
        "name: condition\", for instance \"rubber: y > 5; steel: in "
        "housing\". Conditions are expressions of the cell's centre ") +
        condition_variables);
    prm.add_parameter(
      "Rigid",
      is_rigid,
      "A rigid body: it stays where it is unless a condition of the type "
      "'rigid motion' moves it. Tools (generators 'tool_...') are rigid.");
  }



  bool
  BodyParameters::is_tool() const
  {
    return stickslip::is_tool(generator);
  }



  void
  BodyParameters::check(const std::string &path) const
  {
    if (generator.empty() && mesh_file.empty())
      throw UserError(path +
                      ": neither 'Generator' nor 'Mesh file' is given. "
                      "One of them makes the body.");
    if (!generator.empty() && !mesh_file.empty())
      throw UserError(path + ": 'Generator = " + generator +
                      "' and 'Mesh file = " + mesh_file +
                      "' are both given. Choose one.");
    if (generator.empty() && !arguments.empty())
      throw UserError(path + "/Arguments: '" + arguments +
                      "' is given without a 'Generator'.");

    if (is_tool() && !coordinates.empty())
      throw UserError(path + "/Coordinates: '" + coordinates +
                      "' cannot be, since the shape of a rigid tool ('" +
                      generator + "') is what its arguments say.");

    if (mesh_file.empty() && !mesh_groups.empty())
      throw UserError(path + "/Mesh group: '" + mesh_groups[0] +
                      "' is given without a 'Mesh file'.");

    for (const double factor : scale)
      if (!(factor > 0.))
        throw UserError(path + "/Scale: factors must be positive, found " +
                        std::to_string(factor) + ".");
    if (rotation_angle != 0. && rotation_axis[0] == 0. &&
        rotation_axis[1] == 0. && rotation_axis[2] == 0.)
      throw UserError(path + "/Rotation axis: the direction is zero.");
    if (material.empty() && material_regions.empty() && !moves_as_a_whole())
      throw UserError(path +
                      "/Material: a deformable body needs the name of a "
                      "section of 'Materials'.");

    ConditionList(boundary_ids, path + "/Boundary ids").check_boundary_labels();
    ConditionList(material_regions, path + "/Material regions");
  }
} // namespace stickslip
