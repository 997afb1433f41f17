// A sixteenth of a flange joint with eight bolts (half a bolt, half the way to the next), in mm. The bolt is two
// volumes that share the surface `cut`; the flanges and the bolt share nothing.
//
//   gmsh -3 flange.geo -o flange.msh              (-setnumber size 4 -setnumber hexahedra 1)
SetFactory("OpenCASCADE");
DefineConstant[ size = 5, hexahedra = 0 ];

inner = 40;  // of the pipe
pipe  = 46;  // its outer radius
outer = 95;  // of the flange
circle = 72; // of the bolts
hole = 8; shank = 7; head = 12; // radii
head_height = 9;
neck = 30;      // length of the pipe
upper = 16;     // thicknesses of the flanges
lower = -20;
angle = Pi/8;

// Extrudes the surfaces from() by dz; made() has end, volume and sides of each.
Macro Extruded
  If (hexahedra)
    Recombine Surface{from()};
    made() = Extrude{0, 0, dz}{ Surface{from()}; Layers{Ceil(Fabs(dz)/size)}; Recombine; };
  Else
    made() = Extrude{0, 0, dz}{ Surface{from()}; };
  EndIf
Return

// A flange from the plane z = 0 to z = thickness, and the pipe beyond it.
Macro Flange
  p = newp;
  Point(p)     = {0, 0, 0};
  Point(p + 1) = {inner, 0, 0};
  Point(p + 2) = {pipe, 0, 0};
  Point(p + 3) = {pipe*Cos(angle), pipe*Sin(angle), 0};
  Point(p + 4) = {inner*Cos(angle), inner*Sin(angle), 0};
  Point(p + 5) = {circle - hole, 0, 0};
  Point(p + 6) = {circle, hole, 0};
  Point(p + 7) = {circle + hole, 0, 0};
  Point(p + 8) = {outer, 0, 0};
  Point(p + 9) = {outer*Cos(angle), outer*Sin(angle), 0};
  Point(p + 10) = {circle, 0, 0};
  c = newl;
  Line(c)       = {p + 1, p + 2};
  Circle(c + 1) = {p + 2, p, p + 3};
  Line(c + 2)   = {p + 3, p + 4};
  Circle(c + 3) = {p + 4, p, p + 1};
  Line(c + 4)   = {p + 2, p + 5};
  Circle(c + 5) = {p + 5, p + 10, p + 6};
  Circle(c + 6) = {p + 6, p + 10, p + 7};
  Line(c + 7)   = {p + 7, p + 8};
  Circle(c + 8) = {p + 8, p, p + 9};
  Line(c + 9)   = {p + 9, p + 3};
  loop = newll;
  Curve Loop(loop)     = {c : c + 3};
  Curve Loop(loop + 1) = {c + 4, c + 5, c + 6, c + 7, c + 8, c + 9, -(c + 1)};
  s = news;
  Plane Surface(s)     = {loop};
  Plane Surface(s + 1) = {loop + 1};
  joint() += {s, s + 1};
  from() = {s, s + 1};
  dz = thickness;
  Call Extruded;
  body() = {made(1), made(7)};
  seat = made(6);
  oblique() += {made(4), made(13)};
  bore() += {made(5)};
  from() = {made(0)};
  dz = (thickness > 0 ? neck : -neck);
  Call Extruded;
  body() += {made(1)};
  oblique() += {made(4)};
  bore() += {made(5)};
  end = made(0);
Return

// The head of a bolt on the end `disc` of its shank, at z.
Macro Head
  p = newp;
  Point(p)     = {circle, 0, z};
  Point(p + 1) = {circle - head, 0, z};
  Point(p + 2) = {circle, head, z};
  Point(p + 3) = {circle + head, 0, z};
  e = 0.01;
  left()      = Point In BoundingBox{circle - shank - e, -e, z - e, circle - shank + e, e, z + e};
  right()     = Point In BoundingBox{circle + shank - e, -e, z - e, circle + shank + e, e, z + e};
  left_arc()  = Curve In BoundingBox{circle - shank - e, -e, z - e, circle + e, shank + e, z + e};
  right_arc() = Curve In BoundingBox{circle - e, -e, z - e, circle + shank + e, shank + e, z + e};
  c = newl;
  Circle(c)     = {p + 1, p, p + 2};
  Circle(c + 1) = {p + 2, p, p + 3};
  Line(c + 2)   = {p + 3, right(0)};
  Line(c + 3)   = {left(0), p + 1};
  loop = newll;
  Curve Loop(loop) = {c, c + 1, c + 2, right_arc(0), left_arc(0), c + 3};
  ring = news;
  Plane Surface(ring) = {loop};
  from() = {disc, ring};
  Call Extruded;
Return

joint() = {};
oblique() = {};
bore() = {};
thickness = upper;
Call Flange;
upper_flange() = body();
upper_seat() = {seat};
upper_end = end;
thickness = lower;
Call Flange;
lower_flange() = body();
lower_seat() = {seat};
lower_end = end;

p = newp;
Point(p)     = {circle, 0, 0};
Point(p + 1) = {circle - shank, 0, 0};
Point(p + 2) = {circle, shank, 0};
Point(p + 3) = {circle + shank, 0, 0};
c = newl;
Circle(c)     = {p + 1, p, p + 2};
Circle(c + 1) = {p + 2, p, p + 3};
Line(c + 2)   = {p + 3, p + 1};
loop = newll;
Curve Loop(loop) = {c : c + 2};
cut = news;
Plane Surface(cut) = {loop};

from() = {cut};
dz = upper;
Call Extruded;
upper_bolt() = {made(1)};
disc = made(0);
z = upper;
dz = head_height;
Call Head;
upper_bolt() += {made(1), made(6)};
upper_seat() += {ring};

from() = {cut};
dz = lower;
Call Extruded;
lower_bolt() = {made(1)};
disc = made(0);
z = lower;
dz = -head_height;
Call Head;
lower_bolt() += {made(1), made(6)};
lower_seat() += {ring};

// What these are called in the .prm file. A group may belong to several bodies.
e = 0.001;
Physical Volume("upper flange") = {upper_flange()};
Physical Volume("lower flange") = {lower_flange()};
Physical Volume("upper bolt")   = {upper_bolt()};
Physical Volume("lower bolt")   = {lower_bolt()};
Physical Surface("joint")       = {joint()};
Physical Surface("cut")         = {cut};
Physical Surface("upper seat")  = {upper_seat()};
Physical Surface("lower seat")  = {lower_seat()};
Physical Surface("bore")        = {bore()};
Physical Surface("upper end")   = {upper_end};
Physical Surface("lower end")   = {lower_end};
Physical Surface("oblique")     = {oblique()};
Physical Surface("through bolt") = Surface In BoundingBox{0, -e, -1000, 1000, e, 1000};

Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.RecombinationAlgorithm = 3; // quadrilaterals only
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
