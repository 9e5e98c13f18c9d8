// The inside of the vessel of cad_vessel.toml, 0.4 x 0.2 x 0.2 m: a half cylinder at one end; at the
// other a floor and a leaning wall that meet at 50 degrees; on the floor a baffle that leaves a way past it.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 0.3, 0.2, 0.2};
Cylinder(2) = {0.3, 0.1, 0, 0, 0, 0.2, 0.1};

// What leans over the floor, up to 0.08 m, and stands upright from there on.
reach = 0.08 / Tan(50 * Pi / 180);
Point(101) = {0, -0.01, 0};
Point(102) = {reach, -0.01, 0.08};
Point(103) = {reach, -0.01, 0.21};
Point(104) = {-0.01, -0.01, 0.21};
Point(105) = {-0.01, -0.01, 0};
For k In {1:5}
  Line(100 + k) = {100 + k, 101 + k % 5};
EndFor
Curve Loop(106) = {101:105};
Plane Surface(107) = {106};
leaning[] = Extrude {0, 0.22, 0} { Surface{107}; };

Box(200) = {0.18, -0.01, -0.01, 0.025, 0.15, 0.06};

BooleanUnion(300) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanDifference(301) = { Volume{300}; Delete; }{ Volume{leaning[1]}; Volume{200}; Delete; };
