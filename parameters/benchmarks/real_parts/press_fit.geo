// A quarter of a hollow shaft in a hub with the same ends, in mm. The shaft is larger than the bore of the hub.
//
//   gmsh -3 press_fit.geo -o press_fit.msh        (-setnumber size 2 -setnumber hexahedra 1)
SetFactory("OpenCASCADE");
DefineConstant[ size = 4, hexahedra = 0 ];

inner   = 10;
fit     = 20;
outer   = 35;
overlap = 0.02; // of the radii
length  = 20;

// A quarter of a ring, from r1 to r2, extruded: `made` is its end, the volume, and its sides.
Macro Ring
  p = newp;
  Point(p)     = {0, 0, 0};
  Point(p + 1) = {r1, 0, 0};
  Point(p + 2) = {r2, 0, 0};
  Point(p + 3) = {0, r2, 0};
  Point(p + 4) = {0, r1, 0};
  c = newl;
  Line(c)       = {p + 1, p + 2};
  Circle(c + 1) = {p + 2, p, p + 3};
  Line(c + 2)   = {p + 3, p + 4};
  Circle(c + 3) = {p + 4, p, p + 1};
  loop = newll;
  Curve Loop(loop) = {c : c + 3};
  s = news;
  Plane Surface(s) = {loop};
  If (hexahedra)
    Transfinite Curve{c, c + 2}     = Ceil((r2 - r1)/size) + 1;
    Transfinite Curve{c + 1, c + 3} = around;
    Transfinite Surface{s};
    Recombine Surface{s};
    made() = Extrude{0, 0, length}{ Surface{s}; Layers{Ceil(length/size)}; Recombine; };
  Else
    made() = Extrude{0, 0, length}{ Surface{s}; };
  EndIf
Return

r1 = inner;
r2 = fit + overlap;
around = Ceil(Pi/2*fit/size) + 1;
Call Ring;
shaft = made(1);
outer_side = made(3);

r1 = fit;
r2 = outer;
around += 2; // the meshes do not match
Call Ring;
hub = made(1);
hole = made(5);

// A group may belong to both bodies. Boxes have a margin, for the curved sides.
e = 0.001;
Physical Volume("shaft")       = {shaft};
Physical Volume("hub")         = {hub};
Physical Surface("fit") = {outer_side};
Physical Surface("hole") = {hole};
Physical Surface("symmetry x") = Surface In BoundingBox{-e, -e, -e, e, outer + e, length + e};
Physical Surface("symmetry y") = Surface In BoundingBox{-e, -e, -e, outer + e, e, length + e};
Physical Surface("seat")       = Surface In BoundingBox{-e, -e, -e, outer + e, outer + e, e};
Physical Surface("pushed")     = Surface In BoundingBox{-e, -e, length - e, fit + overlap + e, fit + overlap + e, length + e};

Mesh.ElementOrder  = 2;
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
