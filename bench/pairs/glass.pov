// The scene of `glint new glass`.
#version 3.7;
#declare Depth = 12;
#declare Ambient = <0.15, 0.15, 0.17>;
#include "common.inc"

View(<0, -8, 2.6>, <0, 0, 1>, 34)
background { rgb <0.6, 0.7, 0.8> }
plane { z, 0 pigment { rgb <0.687, 0.645, 0.552> } finish { diffuse 0.9 } }

#declare Blue = pigment { rgb <0.0612, 0.2232, 0.4564> };
#declare Gold = pigment { rgb <0.7011, 0.3763, 0.0144> };
#macro Bar(X, Colour) box { <X - 0.4, 2.8, 0>, <X + 0.4, 3.2, 3> pigment { Colour } } #end
Bar(-2.4, Blue)
Bar(-0.8, Gold)
Bar(0.8, Blue)
Bar(2.4, Gold)

sphere {
    <-1.1, 0, 1.15>, 1.1
    Glass(0.95, 1.5)
    finish { phong 0.8 phong_size 300 }
}
box {
    <-0.55, -0.55, -0.9>, <0.55, 0.55, 0.9>
    rotate 30 * z
    translate <1.4, 0.1, 0.95>
    Glass(0.95, 1.5)
    finish { phong 0.6 phong_size 200 }
    interior { ior 1.5 fade_power 1001 fade_distance 1 fade_color <0.1, 0.85, 0.5> }
}

Lamp(<-3, -5, 7>, 60)
light_source {
    <4, -3, 6> rgb <1, 0.9, 0.75> * 45 / 2
    fade_distance 1 fade_power 2
    spotlight radius 16.8 falloff 28 tightness 0 point_at <1, 0.5, 1>
}
