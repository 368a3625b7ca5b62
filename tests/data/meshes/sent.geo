// A plate of 50 x 100 mm with small elements at the tip of an edge crack of 20 mm at mid-height. In quadrilaterals:
//   gmsh -2 sent.geo -setnumber quads 1 -o sent-quads.msh
// and with triangles among them:
//   gmsh -2 sent.geo -setnumber quads 0 -o sent-mixed.msh
DefineConstant[ quads = 1 ];
Point(1) = {0, 0, 0};
Point(2) = {50, 0, 0};
Point(3) = {50, 100, 0};
Point(4) = {0, 100, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
s = 2 - quads;  // what is split into quadrilaterals may be twice as large
Field[1] = MathEval;
Field[1].F = Sprintf("%g * (0.4 + 0.12 * Sqrt((x - 20)^2 + (y - 50)^2))", s);
Field[2] = MathEval;
Field[2].F = Sprintf("%g * 3", s);
Field[3] = Min;
Field[3].FieldsList = {1, 2};
Background Field = 3;
Physical Curve("bottom") = {1};
Physical Curve("top") = {3};
Physical Surface("plate") = {1};
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.RecombinationAlgorithm = quads;  // 1: blossom; 0: the simple one leaves triangles
Mesh.MshFileVersion = 2.2;
