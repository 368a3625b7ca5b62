// A wide plate with a round hole; small elements along the ways of cracks from it. The mesh of the case is that of
//   gmsh -2 plate-hole.geo -o plate-hole.msh
R = 5;      // of the hole, mm
W = 600;    // width and height of the plate
h = 0.125;  // element edge along the ways of the cracks

Point(1) = {-W/2, -W/2, 0};
Point(2) = {W/2, -W/2, 0};
Point(3) = {W/2, W/2, 0};
Point(4) = {-W/2, W/2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};

Point(5) = {0, 0, 0};
Point(6) = {R, 0, 0};
Point(7) = {0, R, 0};
Point(8) = {-R, 0, 0};
Point(9) = {0, -R, 0};
Circle(5) = {6, 5, 7};
Circle(6) = {7, 5, 8};
Circle(7) = {8, 5, 9};
Circle(8) = {9, 5, 6};
Curve Loop(2) = {5, 6, 7, 8};

Plane Surface(1) = {1, 2};

// The ways of the cracks are no part of the mesh: they ask for sizes alone, the hole for 0.3 mm.
Point(10) = {3.2*R, 0, 0};
Point(11) = {-3.2*R, 0, 0};
Line(9) = {6, 10};
Line(10) = {8, 11};
Field[1] = Distance;
Field[1].CurvesList = {9, 10};
Field[1].NumPointsPerCurve = 200;
Field[2] = Distance;
Field[2].CurvesList = {5, 6, 7, 8};
Field[2].NumPointsPerCurve = 100;
Field[3] = MathEval;
Field[3].F = Sprintf("%g + 0.2*F1", h);
Field[4] = MathEval;
Field[4].F = "0.3 + 0.2*F2";
Field[5] = MathEval;
Field[5].F = "40";
Field[6] = Min;
Field[6].FieldsList = {3, 4, 5};
Background Field = 6;

Physical Curve("bottom") = {1};
Physical Curve("top") = {3};
Physical Curve("hole") = {5, 6, 7, 8};
Physical Surface("plate") = {1};

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.RecombinationAlgorithm = 1;
Mesh.MshFileVersion = 4.1;
