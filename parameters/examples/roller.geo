// A quarter of a cylinder on half of a block, symmetric to x = 0, in mm. The
// mesh (roller.msh) was made of this file with
//
//   gmsh -2 roller.geo -o roller.msh
//
// The two bodies share no points, although they touch.
Mesh.RecombineAll          = 1;
Mesh.RecombinationAlgorithm = 3; // quadrilaterals only
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints    = 0;

// The cylinder, radius 10, above the block.
Point(1) = {0, 0, 0};
Point(2) = {10, 10, 0};
Point(3) = {0, 10, 0};
Circle(1) = {1, 3, 2};
Line(2)   = {2, 3};
Line(3)   = {3, 1};
Curve Loop(1)    = {1, 2, 3};
Plane Surface(1) = {1};

// The block.
Point(11) = {0, -20, 0};
Point(12) = {20, -20, 0};
Point(13) = {20, 0, 0};
Point(14) = {0, 0, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Curve Loop(2)    = {11, 12, 13, 14};
Plane Surface(2) = {2};

// Small cells where they touch.
Field[1]       = MathEval;
Field[1].F     = "0.15 + 0.2*Max(0, Sqrt(x*x + y*y) - 2)";
Background Field = 1;

// What these are called in the .prm file.
Physical Surface("roller")   = {1};
Physical Surface("block")    = {2};
Physical Curve("tread")      = {1};
Physical Curve("axle")       = {2};
Physical Curve("rail")       = {13};
Physical Curve("foundation") = {11};
Physical Curve("symmetry")   = {3, 14};
