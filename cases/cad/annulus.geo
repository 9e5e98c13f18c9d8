// The gap between a shaft (radius 0.04 m) and its housing (radius 0.10 m), as a flat surface.
SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 0.10};
Disk(2) = {0, 0, 0, 0.04};
BooleanDifference{ Surface{1}; Delete; }{ Surface{2}; Delete; }
