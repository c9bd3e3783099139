#version 3.7;
#declare Depth = 12;
#declare Ambient = <0.2, 0.2, 0.2>;
#include "common.inc"

View(<0, -8, 3>, <0, 0, 1.3>, 36)
background { rgb <0.55, 0.65, 0.8> }
plane { z, 0 pigment { rgb <0.6, 0.6, 0.55> } }
sphere { <0, 0, 1.55>, 1.5 Glass(1, 1.5) }
sphere {
    <0, 0, 1.55>, 1.3
    Glass(1, 1.33)
    interior { ior 1.33 fade_power 1001 fade_distance 1 fade_color <0.6, 0.9, 0.95> }
}
sphere { <0.1, -0.2, 1.6>, 0.8 Glass(1, 1) }
sphere { <0.1, -0.2, 1.6>, 0.35 pigment { rgb <0.85, 0.8, 0.75> } }
sphere { <-2, 2.5, 0.8>, 0.8 pigment { rgb <0.7, 0.1, 0.08> } }
sphere { <2.1, 2, 0.8>, 0.8 pigment { rgb <0.1, 0.2, 0.6> } }
Lamp(<-4, -5, 8>, 80)
