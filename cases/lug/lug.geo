// A lug with a round hole for its pin. Small elements along the way of the crack. The mesh of the case is that of
//   gmsh -2 lug.geo -o lug.msh
R = 15;      // of the hole, mm
B = 30;      // of the head
L = 90;      // from the middle of the hole to the root
h = 0.25;    // element edge along the way of the crack

Point(1) = {0, 0, 0};
Point(2) = {B, 0, 0};
Point(3) = {0, B, 0};
Point(4) = {-B, 0, 0};
Point(5) = {-B, -L, 0};
Point(6) = {B, -L, 0};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {6, 2};
Curve Loop(1) = {1, 2, 3, 4, 5};
Point(11) = {R, 0, 0};
Point(12) = {0, R, 0};
Point(13) = {-R, 0, 0};
Point(14) = {0, -R, 0};
For q In {1:4}
  Circle(10 + q) = {10 + q, 1, 11 + q % 4};
EndFor
Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(1) = {1, 2};

Point(20) = {0.75*B, 0, 0};
Line(20) = {11, 20};
Field[1] = Distance;
Field[1].CurvesList = {20};
Field[1].NumPointsPerCurve = 100;
Field[2] = MathEval;
Field[2].F = Sprintf("%g + 0.2*F1", h);
Field[3] = Distance;
Field[3].CurvesList = {11:14};
Field[3].NumPointsPerCurve = 50;
Field[4] = MathEval;
Field[4].F = "1 + 0.3*F3";
Field[5] = Min;
Field[5].FieldsList = {2, 4};
Background Field = 5;

Physical Curve("hole") = {11:14};
Physical Curve("root") = {4};
Physical Curve("head") = {1, 2};
Physical Surface("lug") = {1};

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMax = 5;
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.RecombinationAlgorithm = 3;  // leaves no triangle
Mesh.MshFileVersion = 4.1;
