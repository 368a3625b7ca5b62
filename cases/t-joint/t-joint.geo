// A plate with an attachment and two fillet welds. Small elements along the way of a crack from the right weld toe. The
// mesh of the case is that of
//   gmsh -2 t-joint.geo -o t-joint.msh
t = 12;    // plate, mm
L = 120;   // its length
s = 10;    // attachment
H = 40;    // its height
z = 8;     // leg of the welds
h = 0.125; // element edge along the way of the crack

Point(1) = {-L/2, 0, 0};
Point(2) = {L/2, 0, 0};
Point(3) = {L/2, t, 0};
Point(4) = {s/2 + z, t, 0};
Point(5) = {s/2, t, 0};
Point(6) = {-s/2, t, 0};
Point(7) = {-s/2 - z, t, 0};
Point(8) = {-L/2, t, 0};
Point(9) = {s/2, t + z, 0};
Point(10) = {s/2, t + H, 0};
Point(11) = {-s/2, t + H, 0};
Point(12) = {-s/2, t + z, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 1};
Line(9) = {5, 9};
Line(10) = {9, 10};
Line(11) = {10, 11};
Line(12) = {11, 12};
Line(13) = {12, 6};
Line(14) = {4, 9};
Line(15) = {7, 12};

Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8};
Curve Loop(2) = {-5, 9, 10, 11, 12, 13};
Curve Loop(3) = {-4, 14, -9};
Curve Loop(4) = {-6, -13, -15};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Plane Surface(4) = {4};

// The way of the crack is no part of the mesh: it asks for sizes alone.
Point(20) = {s/2 + z + 0.5, 0.3*t, 0};
Line(20) = {4, 20};
Field[1] = Distance;
Field[1].CurvesList = {20};
Field[1].NumPointsPerCurve = 200;
Field[2] = MathEval;
Field[2].F = Sprintf("%g + 0.2*F1", h);
Field[3] = MathEval;
Field[3].F = "2";
Field[4] = Min;
Field[4].FieldsList = {2, 3};
Background Field = 4;

Physical Curve("left") = {8};
Physical Curve("right") = {2};
Physical Curve("attachment-top") = {11};
Physical Surface("plate") = {1};
Physical Surface("attachment") = {2};
Physical Surface("weld") = {3, 4};

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.RecombinationAlgorithm = 1;
Mesh.MshFileVersion = 4.1;
