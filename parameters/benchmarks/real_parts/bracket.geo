// Half of an angle bracket (symmetric to y = 0) on a block, and the washer that presses on it, in mm.
//
//   gmsh -3 bracket.geo -o bracket.msh            (-setnumber size 2 -setnumber hexahedra 1)
//
// With tetrahedra the inner corner has a fillet. With hexahedra all is extruded along z, and there is none.
SetFactory("OpenCASCADE");
DefineConstant[ size = 5, hexahedra = 0 ];

foot = 60; width = 20; thick = 8; height = 58; fillet = 6;
centre = 38; hole = 5.5; rim = 12; washer_height = 3;

// Extrudes the surfaces from() by dz; made() has end, volume and sides of each.
Macro Extruded
  If (hexahedra)
    Recombine Surface{from()};
    made() = Extrude{0, 0, dz}{ Surface{from()}; Layers{Ceil(dz/size)}; Recombine; };
  Else
    made() = Extrude{0, 0, dz}{ Surface{from()}; };
  EndIf
Return

// Half of the edge of the hole, in the plane z: points hp + 1 to hp + 3, curves ha and ha + 1.
Macro EdgeOfHole
  hp = newp;
  Point(hp)     = {centre, 0, z};
  Point(hp + 1) = {centre - hole, 0, z};
  Point(hp + 2) = {centre, hole, z};
  Point(hp + 3) = {centre + hole, 0, z};
  ha = newl;
  Circle(ha)     = {hp + 1, hp, hp + 2};
  Circle(ha + 1) = {hp + 2, hp, hp + 3};
Return

If (hexahedra)
  z = 0;
  Call EdgeOfHole;
  p = newp;
  Point(p)     = {0, 0, 0};
  Point(p + 1) = {thick, 0, 0};
  Point(p + 2) = {thick, width, 0};
  Point(p + 3) = {0, width, 0};
  Point(p + 4) = {foot, 0, 0};
  Point(p + 5) = {foot, width, 0};
  c = newl;
  Line(c)     = {p, p + 1};
  Line(c + 1) = {p + 1, p + 2};
  Line(c + 2) = {p + 2, p + 3};
  Line(c + 3) = {p + 3, p};
  Line(c + 4) = {p + 1, hp + 1};
  Line(c + 5) = {hp + 3, p + 4};
  Line(c + 6) = {p + 4, p + 5};
  Line(c + 7) = {p + 5, p + 2};
  Curve Loop(1) = {c : c + 3};
  Curve Loop(2) = {c + 4, ha, ha + 1, c + 5, c + 6, c + 7, -(c + 1)};
  Plane Surface(1) = {1};
  Plane Surface(2) = {2};
  from() = {1, 2};
  dz = thick;
  Call Extruded;
  bracket() = {made(1), made(7)};
  from() = {made(0)};
  dz = height - thick;
  Call Extruded;
  bracket() += {made(1)};
Else
  Point(1) = {0, 0, 0};
  Point(2) = {foot, 0, 0};
  Point(3) = {foot, 0, thick};
  Point(4) = {thick + fillet, 0, thick};
  Point(5) = {thick + fillet, 0, thick + fillet};
  Point(6) = {thick, 0, thick + fillet};
  Point(7) = {thick, 0, height};
  Point(8) = {0, 0, height};
  Line(1) = {1, 2};
  Line(2) = {2, 3};
  Line(3) = {3, 4};
  Circle(4) = {4, 5, 6};
  Line(5) = {6, 7};
  Line(6) = {7, 8};
  Line(7) = {8, 1};
  Curve Loop(1) = {1 : 7};
  Plane Surface(1) = {1};
  made() = Extrude{0, width, 0}{ Surface{1}; };
  drill = newv;
  Cylinder(drill) = {centre, 0, -1, 0, 0, thick + 2, hole};
  bracket() = BooleanDifference{ Volume{made(1)}; Delete; }{ Volume{drill}; Delete; };
EndIf

z = thick;
Call EdgeOfHole;
p = newp;
Point(p)     = {centre - rim, 0, z};
Point(p + 1) = {centre, rim, z};
Point(p + 2) = {centre + rim, 0, z};
c = newl;
Circle(c)     = {p, hp, p + 1};
Circle(c + 1) = {p + 1, hp, p + 2};
Line(c + 2)   = {p + 2, hp + 3};
Line(c + 3)   = {hp + 1, p};
loop = newll;
Curve Loop(loop) = {c, c + 1, c + 2, -(ha + 1), -ha, c + 3};
from() = {news};
Plane Surface(from(0)) = {loop};
dz = washer_height;
Call Extruded;
washer = made(1);

s = news;
Rectangle(s) = {-10, 0, -20, foot + 20, width + 10};
from() = {s};
dz = 20;
Call Extruded;
block = made(1);

// What these are called in the .prm file. A group may belong to several bodies.
e = 0.001;
Physical Volume("bracket") = {bracket()};
Physical Volume("washer")  = {washer};
Physical Volume("block")   = {block};
Physical Surface("foot")       = Surface In BoundingBox{-100, -e, -e, 100, 100, e};
Physical Surface("under washer") = Surface In BoundingBox{-100, -e, thick - e, 100, 100, thick + e};
Physical Surface("washer top") = Surface In BoundingBox{-100, -e, thick + washer_height - e, 100, 100, thick + washer_height + e};
Physical Surface("top")        = Surface In BoundingBox{-100, -e, height - e, 100, 100, height + e};
Physical Surface("ground")     = Surface In BoundingBox{-100, -e, -20 - e, 100, 100, -20 + e};
Physical Surface("symmetry")   = Surface In BoundingBox{-100, -e, -100, 100, e, 100};

Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.RecombinationAlgorithm = 3; // quadrilaterals only
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
