// A hook with a round nose, and the catch that is pushed over it, in mm.
//
//   gmsh -2 snap_fit.geo -o snap_fit.msh          (-setnumber size 0.3 -setnumber hexahedra 1: quadrilaterals)
SetFactory("OpenCASCADE");
DefineConstant[ size = 0.5, hexahedra = 0 ];

// The hook: a cantilever along x, clamped at x = 0; its nose is half of a disc.
nose = 22; radius = 1.5; thick = 2; end = 24;
Point(1) = {0, 0, 0};
Point(2) = {end, 0, 0};
Point(3) = {end, thick, 0};
Point(4) = {nose + radius, thick, 0};
Point(5) = {nose, thick, 0};
Point(6) = {nose, thick + radius, 0};
Point(7) = {nose - radius, thick, 0};
Point(8) = {0, thick, 0};
Line(1)   = {1, 2};
Line(2)   = {2, 3};
Line(3)   = {3, 4};
Circle(4) = {4, 5, 6};
Circle(5) = {6, 5, 7};
Line(6)   = {7, 8};
Line(7)   = {8, 1};
Curve Loop(1) = {1 : 7};
Plane Surface(1) = {1};

// The catch: its tooth has a slope of 30 degrees on the left, one of 45 on the right, and reaches 1.2 below the nose.
bottom = 3.8; tip = 2.3; top = 8; flat = 3;
first = 23;
Point(11) = {first - 3, bottom, 0};
Point(12) = {first, bottom, 0};
Point(13) = {first + (bottom - tip)/Tan(Pi/6), tip, 0};
Point(14) = {first + (bottom - tip)/Tan(Pi/6) + flat, tip, 0};
Point(15) = {first + (bottom - tip)/Tan(Pi/6) + flat + bottom - tip, bottom, 0};
Point(16) = {first + 11, bottom, 0};
Point(17) = {first + 11, top, 0};
Point(18) = {first - 3, top, 0};
For i In {11 : 17}
  Line(i) = {i, i + 1};
EndFor
Line(18) = {18, 11};
Curve Loop(2) = {11 : 18};
Plane Surface(2) = {2};

If (hexahedra)
  Recombine Surface{1, 2};
EndIf

// What these are called in the .prm file.
Physical Surface("hook")  = {1};
Physical Surface("catch") = {2};
Physical Curve("clamp")   = {7};
Physical Curve("nose")    = {3, 4, 5, 6};
Physical Curve("tooth")   = {11 : 15};
Physical Curve("hand")    = {17};

Mesh.ElementOrder = 2;
Mesh.RecombinationAlgorithm = 3; // quadrilaterals only
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
