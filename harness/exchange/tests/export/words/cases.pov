
== sides (1 lines stand above)
// scene: -- <&
// Linear radiance, one ray through the centre of each pixel:
//   povray +Ithis.pov +Othis.png +W1 +H1 -A -D +FN16 File_Gamma=1.0
#version 3.7;
#declare exposure = 1;
global_settings {
  assumed_gamma 1
  ambient_light rgb exposure*<0, 0, 0>
  max_trace_level 8
  adc_bailout 0
}
background { rgb exposure*<0, 0, 0> }
camera {
  perspective
  location <0, 0, 5>
  direction <-0, -0, -1000>
  right <1, 0, 0>
  up <0, 1, 0>
light_source { <267261.2419124244, 534522.4838248488, 801783.7257372732> rgb exposure*<1, 1, 1> parallel point_at <0, 0, 0> }
#declare front_0 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0.25 diffuse 0.5/pi } }
#declare back_0 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0.25 diffuse 0/pi } }
#declare front_1 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0.25 diffuse 0.5/pi } }
#declare back_1 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0.25 diffuse 0.5/pi } }
#declare front_2 = texture { pigment { rgb <0, 0, 0> } finish { ambient 0 diffuse 0/pi reflection { rgb <0.5, 0.25, 0.125> } } }
#declare back_2 = texture { pigment { rgb <0, 0, 0> } finish { ambient 0 diffuse 0/pi reflection { rgb <0.5, 0.25, 0.125> } } }
#declare front_3 = texture { pigment { rgb <1, 0.5, 0.25> } finish { ambient 0 diffuse 0.25/pi reflection { rgb <0.5, 0.25, 0.125> } } }
#declare back_3 = texture { pigment { rgb <1, 0.5, 0.25> } finish { ambient 0 diffuse 0/pi reflection { rgb <0.5, 0.25, 0.125> } } }
#declare front_4 = texture { pigment { rgb <1, 0.5, 0.25> } finish { ambient 0 diffuse 0/pi emission exposure*4 } }
#declare back_4 = texture { pigment { rgb <0, 0, 0> } finish { ambient 0 diffuse 0/pi } }
cylinder { <0, -1, 0>, <0, 2.5, 0>, 0.5 open texture { front_0 } interior_texture { back_0 } }
cylinder { <0, -1, 0>, <0, 2.5, 0>, 0.5 open texture { back_1 } interior_texture { front_1 } }
sphere { <0, 0, 0>, 1 texture { front_2 } interior_texture { back_2 } }
sphere { <0, 0, 0>, 2 texture { front_3 } interior_texture { back_3 } }
union { 
  triangle { <0, 0, 0>, <2, 1, 0>, <2, 1, 3> }
  triangle { <0, 0, 0>, <2, 1, 3>, <0, 0, 3> }
  texture { back_4 } interior_texture { front_4 } }

== sides, path (0 lines stand above)
refused: tracer: a path tracer; POV-Ray adds up direct light and mirror images, as ray_cast and whitted do

== shadows (18 lines stand above)
  max_trace_level 1
light_source { <267261.2419124244, 534522.4838248488, 801783.7257372732> rgb exposure*<1, 1, 1> parallel point_at <0, 0, 0> shadowless }
#declare front_0 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0 diffuse 0.5/pi } }
#declare back_0 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0 diffuse 0/pi } }
#declare front_1 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0 diffuse 0.5/pi } }
#declare back_1 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0 diffuse 0/pi } }
sphere { <0, 0, 0>, 1 texture { front_0 } interior_texture { back_0 } }
sphere { <0, 0, 0>, 2 texture { front_1 } interior_texture { back_1 } no_shadow }
sphere { <0, 0, 0>, 3 texture { front_0 } interior_texture { back_0 } no_shadow }

== unshadowed (25 lines stand above)
sphere { <0, 0, 0>, 2 texture { front_1 } interior_texture { back_1 } }
sphere { <0, 0, 0>, 3 texture { front_0 } interior_texture { back_0 } }

== still texture (23 lines stand above)
#declare front_0 = texture { pigment { function { (1+2*abs(mod(floor(x/2+-0.000187453738)+floor(y/2+-0.000187453738)+floor(z/2+-0.000187453738),2)))/6 } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0, 0, 0>] [2/3 rgb <0, 0, 0>] [2/3 rgb <1, 1, 1>] } } finish { ambient 0 diffuse 0.5/pi } }
#declare back_0 = texture { pigment { function { (1+2*abs(mod(floor(x/2+-0.000187453738)+floor(y/2+-0.000187453738)+floor(z/2+-0.000187453738),2)))/6 } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0, 0, 0>] [2/3 rgb <0, 0, 0>] [2/3 rgb <1, 1, 1>] } } finish { ambient 0 diffuse 0/pi } }
#declare front_1 = texture { pigment { function { (1+2*abs(mod(floor(x/2+-0.000187453738)+floor(y/2+-0.000187453738)+floor(z/2+-0.000187453738),2)))/6 } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0, 0, 0>] [2/3 rgb <0, 0, 0>] [2/3 rgb <1, 1, 1>] } } finish { ambient 0 diffuse 0.5/pi } }
#declare back_1 = texture { pigment { function { (1+2*abs(mod(floor(x/2+-0.000187453738)+floor(y/2+-0.000187453738)+floor(z/2+-0.000187453738),2)))/6 } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0, 0, 0>] [2/3 rgb <0, 0, 0>] [2/3 rgb <1, 1, 1>] } } finish { ambient 0 diffuse 0/pi } }
sphere { <0, 0, 0>, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 11, 0, 0> texture { front_0 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 10, 0, 0> } interior_texture { back_0 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 10, 0, 0> } }
  texture { back_1 } interior_texture { front_1 } }

== two suns (21 lines stand above)
#declare exposure = 2;
background { rgb exposure*<0.5, 0.25, 0.125> }
light_source { <0, 1000000, 0> rgb exposure*<2, 2, 2> parallel point_at <0, 0, 0> }

== two suns, path (0 lines stand above)
refused: tracer: a path tracer; POV-Ray adds up direct light and mirror images, as ray_cast and whitted do

== sky (0 lines stand above)
refused: lights[0] "sky": source.environment: no counterpart

== sky, path (0 lines stand above)
refused: tracer: a path tracer; POV-Ray adds up direct light and mirror images, as ray_cast and whitted do
refused: lights[0] "sky": source.environment: no counterpart

== glass (18 lines stand above)
background { rgb exposure*<1, 1, 1> }
#declare front_0 = texture { pigment { rgb 0 transmit 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }
#declare back_0 = texture { pigment { rgb 0 transmit 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }
union {
  sphere { <0, 0, 0>, 1 texture { front_0 } interior_texture { back_0 } }
  sphere { <3, 0, 0>, 1 texture { front_0 } interior_texture { back_0 } }
  interior { ior 1.5 } no_shadow }
sphere { <0, 0, 0>, 1 texture { pigment { rgb 0 } } no_image no_reflection }

== attenuated shadows of glass (0 lines stand above)
refused: transparency.shadows: attenuated; POV-Ray's glass casts other shadows, or those of opaque bodies: write opaque

== clear glass (0 lines stand above)
refused: tracer: a path tracer; POV-Ray adds up direct light and mirror images, as ray_cast and whitted do

== glass in glass (0 lines stand above)
refused: materials[0] "it": in or against other glass, or seen from inside: only closed bodies apart from each other in air can be said, because POV-Ray takes the index on the other side from the body around it (pixel 0,0)
refused: materials[1] "inner": in or against other glass, or seen from inside: only closed bodies apart from each other in air can be said, because POV-Ray takes the index on the other side from the body around it (pixel 0,0)

== camera in glass (0 lines stand above)
refused: materials[0] "it": in or against other glass, or seen from inside: only closed bodies apart from each other in air can be said, because POV-Ray takes the index on the other side from the body around it (pixel 0,0)
refused: materials[0] "it": the camera is in its bounding box, where POV-Ray may take it to be inside (pixel 0,0)

== glass in itself (0 lines stand above)
refused: materials[0] "it": in or against other glass, or seen from inside: only closed bodies apart from each other in air can be said, because POV-Ray takes the index on the other side from the body around it (pixel 0,0)

== surface behind glass (22 lines stand above)
light_source { <0, 0, 1000000> rgb exposure*<1, 1, 1> parallel point_at <0, 0, 0> }
#declare front_1 = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { ambient 0 diffuse 0.8/pi } }
#declare back_1 = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { ambient 0 diffuse 0/pi } }
sphere { <0, 0, -5>, 0.25 texture { front_1 } interior_texture { back_1 } }
sphere { <0, 0, 0>, 1 texture { front_0 } interior_texture { back_0 } interior { ior 1.5 } no_shadow }

== surface in glass (0 lines stand above)
refused: materials[0] "it": seen inside glass, where only ours multiplies radiance by 1/η²; --without scaling leaves that out (pixel 0,0)

== surface in glass, unscaled (26 lines stand above)
sphere { <0, 0, 0>, 0.25 texture { front_1 } interior_texture { back_1 } }

== bubble in tint (0 lines stand above)
refused: materials[0] "it": recipe.dielectric.inside.absorption: only clear glass can be said: POV-Ray adds up the absorption of all glass that a ray has entered; --without absorption makes it clear on both sides
refused: materials[1] "inner": recipe.dielectric.outside.absorption: only clear glass can be said: POV-Ray adds up the absorption of all glass that a ray has entered; --without absorption makes it clear on both sides

== bubble, no absorption (0 lines stand above)
refused: materials[1] "inner": in or against other glass, or seen from inside: only closed bodies apart from each other in air can be said, because POV-Ray takes the index on the other side from the body around it (pixel 0,0)
refused: materials[1] "inner": seen inside glass, where only ours multiplies radiance by 1/η²; --without scaling leaves that out (pixel 0,0)

== glass that is matte (0 lines stand above)
refused: materials[0] "it": recipe.transparent.phong.kd: glass is not matte as well there
refused: materials[0] "it": recipe.transparent.phong.ks: the highlight of POV-Ray is not multiplied by the cosine of the angle of incidence; --without phong leaves it out

== glass that is matte, ray_cast (21 lines stand above)
sphere { <0, 0, 0>, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0> texture { front_0 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0> } interior_texture { back_0 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0> } }

== smooth (0 lines stand above)
refused: objects[0] "mesh": shape.tessellated_sphere: the interpolated normal decides which side POV-Ray sees, here the true one does; --without smooth leaves it out
refused: objects[1] "moved": shape.instance.of.tessellated_sphere: the interpolated normal decides which side POV-Ray sees, here the true one does; --without smooth leaves it out

== flat (27 lines stand above)
  triangle { <0, 1, 0>, <0, 6.123233995736766e-17, 1>, <0.8660254037844387, 6.123233995736766e-17, -0.4999999999999998> }
  triangle { <0, 1, 0>, <0.8660254037844387, 6.123233995736766e-17, -0.4999999999999998>, <-0.8660254037844385, 6.123233995736766e-17, -0.5000000000000004> }
  triangle { <0, 1, 0>, <-0.8660254037844385, 6.123233995736766e-17, -0.5000000000000004>, <0, 6.123233995736766e-17, 1> }
  triangle { <0, -1, 0>, <0.8660254037844387, 6.123233995736766e-17, -0.4999999999999998>, <0, 6.123233995736766e-17, 1> }
  triangle { <0, -1, 0>, <-0.8660254037844385, 6.123233995736766e-17, -0.5000000000000004>, <0.8660254037844387, 6.123233995736766e-17, -0.4999999999999998> }
  triangle { <0, -1, 0>, <0, 6.123233995736766e-17, 1>, <-0.8660254037844385, 6.123233995736766e-17, -0.5000000000000004> }
  texture { back_0 } interior_texture { front_0 } }
  triangle { <1, 1, 0>, <1, 6.123233995736766e-17, 1>, <1.8660254037844388, 6.123233995736766e-17, -0.4999999999999998> }
  triangle { <1, 1, 0>, <1.8660254037844388, 6.123233995736766e-17, -0.4999999999999998>, <0.13397459621556151, 6.123233995736766e-17, -0.5000000000000004> }
  triangle { <1, 1, 0>, <0.13397459621556151, 6.123233995736766e-17, -0.5000000000000004>, <1, 6.123233995736766e-17, 1> }
  triangle { <1, -1, 0>, <1.8660254037844388, 6.123233995736766e-17, -0.4999999999999998>, <1, 6.123233995736766e-17, 1> }
  triangle { <1, -1, 0>, <0.13397459621556151, 6.123233995736766e-17, -0.5000000000000004>, <1.8660254037844388, 6.123233995736766e-17, -0.4999999999999998> }
  triangle { <1, -1, 0>, <1, 6.123233995736766e-17, 1>, <0.13397459621556151, 6.123233995736766e-17, -0.5000000000000004> }

== too many (0 lines stand above)
refused: objects[0] "it": shape.lattice: 10000000000000000 shapes, and 200000 are the most

== lens and path (0 lines stand above)
refused: tracer: a path tracer; POV-Ray adds up direct light and mirror images, as ray_cast and whitted do
refused: camera.lens.thin_lens: no counterpart
refused: lights[1] "lamp": source.spot: its edge is a cubic of the cosine there, of the angle here
refused: materials[0] "shiny": recipe.phong.ks: the highlight of POV-Ray is not multiplied by the cosine of the angle of incidence; --without phong leaves it out
refused: materials[2] "clouds": recipe.matte.cd.fbm: a texture
refused: objects[1] "clouds": shape.compound.parts[1].algebraic: no counterpart

== fisheye and ray_cast (0 lines stand above)
refused: lights[1] "lamp": source.spot: its edge is a cubic of the cosine there, of the angle here
refused: materials[0] "shiny": recipe.phong.ks: the highlight of POV-Ray is not multiplied by the cosine of the angle of incidence; --without phong leaves it out
refused: materials[2] "clouds": recipe.matte.cd.fbm: a texture
refused: objects[1] "clouds": shape.compound.parts[1].algebraic: no counterpart
