// A quarter of a pin in a lug (half of its width and of its thickness), in mm,
// of tetrahedra. The mesh (pin_in_lug.msh) was made of this file with
//
//   gmsh -3 pin_in_lug.geo -o pin_in_lug.msh
//
// The two bodies share no points, although they touch.
SetFactory("OpenCASCADE");

radius    = 8;
thickness = 6;  // half of it
overhang  = 3;  // of the pin
n_arc     = 17; // nodes on the half circle, of both bodies

// The lug: a bar with a round end and a hole.
Box(1)      = {-40, 0, 0, 40, 18, thickness};
Cylinder(2) = {0, 0, 0, 0, 0, thickness, 18, Pi};
bar()       = BooleanUnion{ Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(3) = {0, 0, 0, 0, 0, thickness, radius};
lug()       = BooleanDifference{ Volume{bar()}; Delete; }{ Volume{3}; Delete; };

// The pin.
Cylinder(20) = {0, 0, 0, 0, 0, thickness + overhang, radius, Pi};

// What these are called in the .prm file.
Physical Volume("lug")   = {lug()};
Physical Volume("pin")   = {20};
Physical Surface("wall") = {1};
Physical Surface("hole") = {6};
Physical Surface("lug symmetry y") = {2, 8};
Physical Surface("lug symmetry z") = {5};
Physical Surface("shaft")          = {9};
Physical Surface("end")            = {10};
Physical Surface("pin symmetry y") = {12, 13};
Physical Surface("pin symmetry z") = {11};

// Regular facets where they touch, of equal angles.
Transfinite Curve{10, 16, 19, 21} = n_arc;
Transfinite Curve{5, 17}          = 5;
Transfinite Curve{20, 22}         = 7;
Transfinite Surface{6, 9};
Mesh.MeshSizeFromPoints         = 0;
Mesh.MeshSizeExtendFromBoundary = 1;
Mesh.MeshSizeMax                = 6;
