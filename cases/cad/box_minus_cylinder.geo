// A block of 1 x 1 x 0.5 m, centre at the origin, with a hole of radius 0.25 m along z.
SetFactory("OpenCASCADE");
Box(1) = {-0.5, -0.5, -0.25, 1, 1, 0.5};
Cylinder(2) = {0, 0, -1, 0, 0, 2, 0.25};
BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }
