#version 3.7;
#declare Depth = 12;
#declare Ambient = <0.2, 0.2, 0.2>;
#include "common.inc"

View(<0, -3.4, 0.4>, <0, 0, 0>, 60)
box {
    <-4, -4, -4>, <4, 4, 4>
    pigment { rgb <0.55, 0.5, 0.42> }
    finish { ambient 0.3 reflection 0.6 }
}
sphere { <-1.3, 0.4, 0.2>, 0.9 Glass(0.95, 1.5) }
sphere { <0.7, -0.2, -0.3>, 0.9 Glass(0.95, 1.5) }
sphere { <1.2, 1.9, 0.9>, 0.7 Glass(0.95, 1.5) }
sphere { <-0.4, 2.2, -0.8>, 0.8 pigment { rgb <0.8, 0.25, 0.15> } }
Lamp(<1, -3, 3.4>, 14)
