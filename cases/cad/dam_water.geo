// The water of dam.toml: 0.5 m wide, 0.2 m high.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 0.5, 0.2};
