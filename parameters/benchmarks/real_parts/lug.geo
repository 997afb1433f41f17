// A quarter of a pin in a lug (half of the width, half of the thickness), in mm. The pin touches the hole at x > 0.
//
//   gmsh -3 lug.geo -o lug.msh                    (-setnumber size 2 -setnumber hexahedra 1)
SetFactory("OpenCASCADE");
DefineConstant[ size = 3, hexahedra = 0 ];

radius    = 8; // of the pin
clearance = 0.02;
rim       = 18;
length    = 40; // from the wall to the middle of the hole
thickness = 6;  // half of it

// Extrudes the surface s; made() has end, volume and sides.
Macro Extruded
  If (hexahedra)
    Recombine Surface{s};
    made() = Extrude{0, 0, thickness}{ Surface{s}; Layers{Ceil(thickness/size)}; Recombine; };
  Else
    made() = Extrude{0, 0, thickness}{ Surface{s}; };
  EndIf
Return

hole = radius + clearance;
Point(1) = {0, 0, 0};
Point(2) = {-length, 0, 0};
Point(3) = {-hole, 0, 0};
Point(4) = {0, hole, 0};
Point(5) = {hole, 0, 0};
Point(6) = {rim, 0, 0};
Point(7) = {0, rim, 0};
Point(8) = {-length, rim, 0};
Line(1)   = {2, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Line(4)   = {5, 6};
Circle(5) = {6, 1, 7};
Line(6)   = {7, 8};
Line(7)   = {8, 2};
Curve Loop(1) = {1 : 7};
s = 1;
Plane Surface(1) = {1};
Call Extruded;
lug = made(1);
hole() = {made(3), made(4)};
wall = made(8);

Point(101) = {clearance, 0, 0};
Point(102) = {clearance - radius, 0, 0};
Point(103) = {clearance, radius, 0};
Point(104) = {clearance + radius, 0, 0};
Circle(101) = {102, 101, 103};
Circle(102) = {103, 101, 104};
Line(103)   = {104, 102};
Curve Loop(101) = {101 : 103};
s = news;
Plane Surface(s) = {101};
Call Extruded;
pin = made(1);
shaft() = {made(2), made(3)};

// What these are called in the .prm file. A group may belong to several bodies.
e = 0.001;
Physical Volume("lug")   = {lug};
Physical Volume("pin")   = {pin};
Physical Surface("wall") = {wall};
Physical Surface("hole") = {hole()};
Physical Surface("shaft") = {shaft()};
Physical Surface("symmetry y") = Surface In BoundingBox{-100, -e, -e, 100, e, 100};
Physical Surface("symmetry z") = Surface In BoundingBox{-100, -e, -e, 100, 100, e};

Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.RecombinationAlgorithm = 3; // quadrilaterals only
MeshSize{PointsOf{ Surface{hole(), shaft()}; }} = size/2;
Mesh.MeshSizeFromPoints = 1;
Mesh.MeshSizeMax = size;
