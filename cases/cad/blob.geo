// A ball of radius 0.1 m around the origin; blob.toml has it 2.5 times as large.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 0.1};
