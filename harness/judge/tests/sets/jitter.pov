#version 3.7;
global_settings { assumed_gamma 1.0 }
// the picture is the lower two thirds
camera { location <0, 1, -6> direction z * 1.2 up y * 1.5 right x }
background { rgb <0.2, 0.3, 0.4> }
light_source {
  <4, 6, -4> rgb 1 area_light <3, 0, 0>, <0, 0, 3>, 3, 3 jitter area_illumination on
}
plane { y, -0.8 pigment { checker rgb 0.8 rgb 0.3 } }
sphere { <0, 0.2, 0>, 1 pigment { rgb <0.9, 0.2, 0.1> } finish { phong 0.5 reflection 0.2 } }
// POV-Ray has no seed for its jitter, but one sequence of random numbers on one thread: how many of them are drawn above
// the picture is as good as one
box {
  <-0.5, 1.25, -4.8>,
  <-0.5 + 0.001 * mod(Seed, 1000), 1.26 + 0.049 * mod(7 * Seed, 10), -4.79>
  pigment { rgb 0.5 } no_shadow no_reflection
}
