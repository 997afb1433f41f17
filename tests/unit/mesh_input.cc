// build_mesh() with mesh files, and its messages for bad input.

#include "print_mesh.h"

#include <fstream>
#include <string>
#include <vector>

namespace
{
  BodyParameters
  from_file(const std::string &file)
  {
    BodyParameters body;
    body.mesh_file = file;
    body.material  = "steel";
    return body;
  }



  template <int dim>
  void
  show_error(const NamedList<BodyParameters>    &bodies,
             const std::vector<PeriodicRequest> &periodic = {})
  {
    std::string message = "  no error";
    try
      {
        build_mesh<dim>(MeshParameters(), bodies, periodic, comm);
      }
    catch (const UserError &error)
      {
        message = std::string("  ") + error.what();
      }
    print(message);
  }



  void
  write(const std::string &file_name, const std::string &contents)
  {
    if (Utilities::MPI::this_mpi_process(comm) == 0)
      std::ofstream(file_name) << contents;
    MPI_Barrier(comm);
  }



  /// Two unit squares in Gmsh's format 2.2; physical ids 7 and 8 on the left
  /// and right sides, 1 and 2 on the cells. @p first_cell can be spoilt.
  std::string
  gmsh_file(const std::string &first_cell)
  {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n"
           "1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
           "$Elements\n4\n1 1 2 7 1 1 4\n2 1 2 8 2 3 6\n" +
           first_cell + "\n4 3 2 2 2 2 3 6 5\n$EndElements\n";
  }



  void
  test_files()
  {
    write("two_squares.msh", gmsh_file("3 3 2 1 1 1 2 5 4"));
    write("clockwise.msh", gmsh_file("3 3 2 1 1 1 4 5 2"));
    write("triangles.msh",
          "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n"
          "3 0 1 0\n$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n");
    write("truncated.msh", gmsh_file("3 3 2 1 1 1 2 5 4").substr(0, 130));
    write("no_node.msh", gmsh_file("3 3 2 1 1 1 2 5 9"));
    write("binary.msh", "$MeshFormat\n4.1 1 8\n$EndMeshFormat\n");
    write("strange.mesh", "something");
    write("empty.msh", "");
    write("cube.inp",
          "*HEADING\ncube\n*NODE, NSET=ALLNODES\n1, 0., 0., 0.\n2, 1., 0., 0.\n"
          "3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 2.\n6, 1., 0., 2.\n"
          "7, 1., 1., 2.\n8, 0., 1., 2.\n*NSET, NSET=foot, GENERATE\n1, 4\n"
          "*ELEMENT, TYPE=C3D8R, ELSET=EB1\n"
          "1, 1, 2, 3, 4, 5, 6, 7, 8\n*ELSET, ELSET=SS4_E1\n1\n"
          "*SURFACE, NAME=SS4\nSS4_E1, S2\n*SOLID SECTION, ELSET=EB1, "
          "MATERIAL=Default-Steel\n*END STEP\n");
    write("square.ucd",
          "5 2 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 9 9 0\n"
          "1 3 quad 1 2 3 4\n2 5 line 1 2\n");
    write("square.vtk",
          "# vtk DataFile Version 3.0\nsquare\nASCII\nDATASET "
          "UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n"
          "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n9\n");

    BodyParameters squares   = from_file("two_squares.msh");
    squares.material_regions = "rubber: id == 2";
    squares.refinements      = 1;
    show<2>("Gmsh file", {{"squares", squares}});
    show<2>("Gmsh file with a clockwise cell",
            {{"squares", from_file("clockwise.msh")}});
    show<3>("Abaqus file", {{"cube", from_file("cube.inp")}});
    show<2>("UCD file", {{"square", from_file("square.ucd")}});
    show<2>("VTK file", {{"square", from_file("square.vtk")}});
    show<2>("Gmsh file of triangles",
            {{"triangle", from_file("triangles.msh")}});
    MeshParameters elsewhere;
    elsewhere.input_directory = "no_such_folder";
    show<2>("working directory is the second choice",
            {{"square", from_file("square.vtk")}},
            elsewhere);
  }



  /// Two squares with names; "both" has faces of "left" and of "right", and
  /// the first cell belongs to two groups.
  std::string
  gmsh_file_with_names()
  {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n6\n"
           "1 7 \"left\"\n1 8 \"right side\"\n1 9 \"both\"\n"
           "1 10 \"middle\"\n2 1 \"steel part\"\n2 2 \"rubber\"\n"
           "$EndPhysicalNames\n$Nodes\n6\n"
           "1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
           "$Elements\n8\n1 1 2 7 1 1 4\n2 1 2 8 2 3 6\n3 1 2 9 1 4 1\n"
           "4 1 2 9 2 3 6\n5 1 2 10 3 2 5\n6 3 2 1 1 1 2 5 4\n"
           "7 3 2 2 2 2 3 6 5\n8 3 2 3 1 1 2 5 4\n$EndElements\n";
  }



  /// The faces that a label stands for, or the message.
  template <int dim>
  void
  show_boundary(const Mesh<dim>   &mesh,
                const std::string &body,
                const std::string &label)
  {
    std::string text;
    try
      {
        const auto ids =
          mesh.bodies.global_boundary_ids(body, {label}, "Contact/pair/Slave");
        unsigned int n_faces = 0;
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
          if (cell->is_locally_owned())
            for (const auto &face : cell->face_iterators())
              n_faces +=
                face->at_boundary() && ids.count(face->boundary_id()) > 0;
        text = std::to_string(Utilities::MPI::sum(n_faces, comm)) + " faces";
      }
    catch (const UserError &error)
      {
        text = error.what();
      }
    print("  " + body + ", " + label + ": " + text);
  }



  void
  test_names()
  {
    write("names.msh", gmsh_file_with_names());
    BodyParameters body   = from_file("names.msh");
    body.boundary_ids     = "top: y > 0.99; 11: y < 0.01";
    body.material_regions = "brass: in steel part; gum: in 2";
    const auto one        = show<2>("names, one body", {{"one", body}});
    for (const std::string label : {"left",
                                    "right side",
                                    "Right Side",
                                    "both",
                                    "8",
                                    "9",
                                    "top",
                                    "11",
                                    "middle",
                                    "lefd",
                                    "12"})
      show_boundary(one, "one", label);

    BodyParameters first  = from_file("names.msh");
    BodyParameters second = first;
    first.mesh_groups     = {"3"};
    second.mesh_groups    = {"rubber"};
    const auto two =
      show<2>("names, two bodies", {{"first", first}, {"second", second}});
    for (const std::string label : {"left", "middle", "right side"})
      show_boundary(two, "first", label);
    show_boundary(two, "second", "middle");

    BodyParameters cube = from_file("cube.inp");
    cube.boundary_ids   = "7: in foot";
    const auto abaqus   = show<3>("names, Abaqus", {{"cube", cube}});
    for (const std::string label : {"ss4", "7", "foot", "ALLNODES"})
      show_boundary(abaqus, "cube", label);

    print("wrong names");
    second.mesh_groups = {"rubbr"};
    show_error<2>({{"a", second}});
    second.mesh_groups = {"left"};
    show_error<2>({{"a", second}});
    second                  = first;
    second.material_regions = "gum: in rubber";
    show_error<2>({{"a", second}});
    second              = first;
    second.boundary_ids = "5: in rigth side";
    show_error<2>({{"a", second}});
  }



  BodyParameters
  with(std::string BodyParameters::*member, const std::string &value)
  {
    BodyParameters body = generated("hyper_cube", "0 : 1 : true");
    body.*member        = value;
    return body;
  }



  void
  test_errors()
  {
    print("errors");
    show_error<2>({});
    show_error<2>({{"a", BodyParameters()}});
    show_error<2>({{"a", with(&BodyParameters::mesh_file, "x.msh")}});
    show_error<2>({{"a", with(&BodyParameters::generator, "hyper_bal")}});
    show_error<2>({{"a", with(&BodyParameters::generator, "torus")}});
    show_error<2>({{"a", with(&BodyParameters::arguments, "0 : a")}});
    show_error<2>({{"a", with(&BodyParameters::arguments, "0:1:true:2")}});
    show_error<2>({{"a", generated("hyper_shell", "0, 0")}});
    show_error<2>({{"a", generated("hyper_rectangle", "0, 0, 0 : 1, 1, 1")}});
    show_error<2>({{"a", generated("hyper_shell", "0, 0 : 2 : 1 : 8")}});
    show_error<2>(
      {{"a", generated("graded_hyper_rectangle", "0 |2| 1 : 2, 1")}});
    show_error<2>({{"a", generated("annular_sector", "1:2:0:360:1:2")}});
    show_error<2>({{"a", generated("graded_annular_sector", "0, 2:0 |4| 90")}});
    show_error<2>({{"a", with(&BodyParameters::coordinates, "x")}});
    show_error<2>({{"a", with(&BodyParameters::coordinates, "x; y + q")}});
    show_error<2>({{"a", with(&BodyParameters::coordinates, "-x; y")}});
    show_error<2>({{"a", with(&BodyParameters::coordinates, "0; y")}});
    show_error<2>({{"a", with(&BodyParameters::boundary_ids, "7: y > 5")}});
    show_error<2>({{"a", with(&BodyParameters::boundary_ids, "-1: y > 0")}});
    show_error<2>({{"a", with(&BodyParameters::boundary_ids, "7 y > 0")}});
    show_error<2>({{"a", with(&BodyParameters::boundary_ids, "7: y >")}});
    show_error<2>({{"a", with(&BodyParameters::material, "")}});
    show_error<2>(
      {{"a", with(&BodyParameters::material_regions, "m: id == 9")}});
    BodyParameters body = generated("hyper_cube", "");
    body.scale          = {1., -1.};
    show_error<2>({{"a", body}});
    body             = generated("hyper_cube", "");
    body.translation = {1., 1.};
    show_error<3>({{"a", body}});

    for (const std::string file : {"missing.msh",
                                   "empty.msh",
                                   "truncated.msh",
                                   "no_node.msh",
                                   "binary.msh",
                                   "strange.mesh",
                                   "cube.inp",
                                   "."})
      show_error<2>({{"a", from_file(file)}});
    for (const std::string file :
         {"two_squares.msh", "square.ucd", "square.vtk"})
      show_error<3>({{"a", from_file(file)}});

    PeriodicRequest request;
    request.parameter_path                 = "Boundary conditions/sides";
    request.body                           = "b";
    request.first                          = "0";
    request.second                         = "2";
    const NamedList<BodyParameters> bodies = {
      {"a", generated("hyper_cube", "0 : 1 : true")}};
    show_error<2>(bodies, {request});
    request.body = "a";
    show_error<2>(bodies, {request});
    request.second = "9";
    show_error<2>(bodies, {request});

    const Mesh<2> mesh = build_mesh<2>(MeshParameters(), bodies, {}, comm);
    try
      {
        mesh.bodies.global_boundary_ids("a", {"0", "8"}, "Contact/pair/Slave");
      }
    catch (const UserError &error)
      {
        print(std::string("  ") + error.what());
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_files();
  test_names();
  test_errors();
}
