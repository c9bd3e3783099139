#version 3.7;
#declare Depth = 24;
#declare Ambient = <0.12, 0.12, 0.12>;
#include "common.inc"

View(<-1.6, -4, 1.7>, <1.2, 0.8, 1>, 50)
background { rgb <0.02, 0.02, 0.03> }
#declare Mirror = texture { pigment { rgb <0.05, 0.055, 0.06> } finish { reflection 0.9 } }
#declare Gold = texture { pigment { rgb <0.55, 0.36, 0.08> } finish { diffuse 0.7 reflection 0.4 } }
#declare Red = texture { pigment { rgb <0.65, 0.06, 0.05> } finish { reflection 0.1 } }
plane { x, -2 texture { Mirror } }
plane { -x, -2 texture { Mirror } }
plane { z, 0 pigment { rgb <0.5, 0.4, 0.3> } finish { reflection 0.12 } }
plane { -y, -3.2 pigment { rgb <0.16, 0.26, 0.3> } }
sphere { <-0.7, 0.6, 0.6>, 0.6 texture { Gold } }
sphere { <0.8, 0, 0.45>, 0.45 texture { Red } }
cylinder { <0.5, 1.9, 0>, <0.5, 1.9, 1.8>, 0.35 texture { Gold } }
box { <-1.15, -1.45, 0>, <-0.65, -0.95, 0.5> texture { Red } }
Lamp(<0.2, -1.5, 3>, 9)
