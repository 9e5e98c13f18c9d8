// The walls of tank.toml, 0.04 m thick: a room of 0.4 x 0.2 x 0.2 m, open at the top.
SetFactory("OpenCASCADE");
Box(1) = {-0.04, -0.04, -0.04, 0.48, 0.28, 0.24};
Box(2) = {0, 0, 0, 0.4, 0.2, 0.3};
BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }
