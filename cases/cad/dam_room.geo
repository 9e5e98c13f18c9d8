// The room of dam.toml, in which the water may be: 1 m wide, 0.5 m high.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 0.5};
