// A beam on two supports with three round holes beside its crack. Small elements where the crack may go. The mesh of the
// case is that of
//   gmsh -2 three-holes.geo -o three-holes.msh
in = 25.4;   // the body was made in inches
L = 20*in;
H = 8*in;
R = 0.25*in; // of the holes
x = 6*in;    // of their centres
h = 1.6;     // element edge, mm

Point(1) = {0, 0, 0};
Point(2) = {in, 0, 0};      // supports
Point(3) = {L - in, 0, 0};
Point(4) = {L, 0, 0};
Point(5) = {L, H, 0};
Point(6) = {L/2, H, 0};     // load
Point(7) = {0, H, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7};

y[] = {2.75*in, 4.75*in, 6.75*in};
For k In {0:2}
  p = 10 + 10*k;
  Point(p) = {x, y[k], 0};
  Point(p + 1) = {x + R, y[k], 0};
  Point(p + 2) = {x, y[k] + R, 0};
  Point(p + 3) = {x - R, y[k], 0};
  Point(p + 4) = {x, y[k] - R, 0};
  For q In {1:4}
    Circle(p + q) = {p + q, p, p + 1 + q % 4};
  EndFor
  Curve Loop(2 + k) = {p + 1, p + 2, p + 3, p + 4};
EndFor
Plane Surface(1) = {1, 2, 3, 4};

Field[1] = Box;
Field[1].VIn = h;
Field[1].VOut = 12;
Field[1].XMin = 3.8*in;
Field[1].XMax = 6.2*in;
Field[1].YMin = 0.8*in;
Field[1].YMax = 4.9*in;
Field[1].Thickness = 60;
Field[2] = Distance;
Field[2].CurvesList = {31, 32, 33, 34};
Field[2].NumPointsPerCurve = 40;
Field[3] = MathEval;
Field[3].F = "2 + 0.3*F2";
Field[4] = Min;
Field[4].FieldsList = {1, 3};
Background Field = 4;

Physical Curve("bottom") = {1, 2, 3};
Physical Curve("top") = {5, 6};
Physical Curve("lower hole") = {11, 12, 13, 14};
Physical Curve("middle hole") = {21, 22, 23, 24};
Physical Curve("upper hole") = {31, 32, 33, 34};
Physical Surface("beam") = {1};

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.RecombinationAlgorithm = 1;
Mesh.MshFileVersion = 4.1;
