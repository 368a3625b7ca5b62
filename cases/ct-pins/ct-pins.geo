// The compact specimen of ASTM E647 with its round holes; a sector of each pin touches the outer part of its hole. The
// mesh of the case is that of
//   gmsh -2 ct-pins.geo -o ct-pins.msh
W = 50;          // from the load line to the back face, mm
h = 0.4;         // element edge along the way of the crack
contact = Pi/12;  // the pin is thinner than its hole and touches over twice this angle

Point(1) = {-0.25*W, -0.6*W, 0};
Point(2) = {W, -0.6*W, 0};
Point(3) = {W, 0.6*W, 0};
Point(4) = {-0.25*W, 0.6*W, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};

R = 0.125*W;
For side In {0:1}
  sign = 1 - 2*side;
  y = sign*0.275*W;
  p = 10 + 10*side;
  Point(p) = {0, y, 0};  // the middle of the pin, on the load line
  Point(p + 1) = {R*Sin(contact), y + sign*R*Cos(contact), 0};
  Point(p + 2) = {-R*Sin(contact), y + sign*R*Cos(contact), 0};
  Point(p + 3) = {-R, y, 0};
  Point(p + 4) = {0, y - sign*R, 0};
  Point(p + 5) = {R, y, 0};
  Circle(p) = {p + 1, p, p + 2};      // where the pin touches
  Circle(p + 1) = {p + 2, p, p + 3};  // the rest of the hole
  Circle(p + 2) = {p + 3, p, p + 4};
  Circle(p + 3) = {p + 4, p, p + 5};
  Circle(p + 4) = {p + 5, p, p + 1};
  Line(p + 5) = {p, p + 1};
  Line(p + 6) = {p + 2, p};
  Curve Loop(p) = {p, p + 1, p + 2, p + 3, p + 4};
  Curve Loop(p + 1) = {p + 5, p, p + 6};
  Plane Surface(2 + side) = {p + 1};
EndFor
Plane Surface(1) = {1, 10, 20};

Point(30) = {0.2*W, 0, 0};
Point(31) = {0.8*W, 0, 0};
Line(30) = {30, 31};
Field[1] = Distance;
Field[1].CurvesList = {30};
Field[1].NumPointsPerCurve = 200;
Field[2] = Distance;
Field[2].CurvesList = {10:14, 20:24};
Field[2].NumPointsPerCurve = 50;
Field[3] = MathEval;
Field[3].F = Sprintf("%g + 0.15*F1", h);
Field[4] = MathEval;
Field[4].F = Sprintf("%g + 0.15*F2", 0.5);
Field[5] = MathEval;
Field[5].F = "2";
Field[6] = Min;
Field[6].FieldsList = {3, 4, 5};
Background Field = 6;

Physical Curve("holes") = {11:14, 21:24};
Physical Surface("plate") = {1};
Physical Surface("pins") = {2, 3};

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.RecombinationAlgorithm = 3;  // leaves no triangle
Mesh.MshFileVersion = 4.1;
