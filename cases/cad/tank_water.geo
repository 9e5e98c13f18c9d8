// The water of tank.toml: 0.4 x 0.2 m, 0.16 m high.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 0.4, 0.2, 0.16};
