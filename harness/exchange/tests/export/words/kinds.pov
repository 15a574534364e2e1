
== shape (17 lines stand above)
// scene: kinds
// Linear radiance, one ray through the centre of each pixel:
//   povray +Ithis.pov +Othis.png +W4 +H4 -A -D +FN16 File_Gamma=1.0
#version 3.7;
#declare exposure = 1;
global_settings {
  assumed_gamma 1
  ambient_light rgb exposure*<0, 0, 0>
  max_trace_level 1
  adc_bailout 0
}
background { rgb exposure*<0, 0, 0> }
camera {
  perspective
  location <0, 0, 50>
  direction <-0, -0, -10>
  right <4, 0, 0>
  up <0, 4, 0>
light_source { <0, 1000000, 0> rgb exposure*<1, 1, 1> parallel point_at <0, 0, 0> }
#declare front_0 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0.1 diffuse 0.5/pi } }
#declare back_0 = texture { pigment { rgb <1, 1, 1> } finish { ambient 0.1 diffuse 0/pi } }
union { 
  triangle { <0, 0, 0>, <1, 0, 0>, <1, 0, 1> }
  triangle { <0, 0, 0>, <1, 0, 1>, <0, 0, 1> }
  texture { back_0 } interior_texture { front_0 } }
plane { <0, 1, 0>, 0 texture { front_0 } interior_texture { back_0 } }
plane { <-0.2672612419124244, 0.5345224838248488, 0.8017837257372732>, 0.33407655239053047 texture { front_0 } interior_texture { back_0 } }
sphere { <0, 0, 0>, 1 texture { front_0 } interior_texture { back_0 } }
sphere { <0.5, -0.75, 0.25>, 0.3 texture { front_0 } interior_texture { back_0 } }
box { <-1, -1, -1>, <1, 1, 1> texture { front_0 } interior_texture { back_0 } }
box { <-0.5, 0.25, -2>, <1.5, 0.5, -1> texture { front_0 } interior_texture { back_0 } }
triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> texture { back_0 } interior_texture { front_0 } }
triangle { <-1.1, -0.85, 0.8>, <1.2, 0.1, 0.2>, <-0.4, 0.5, -0.3> texture { back_0 } interior_texture { front_0 } }
  triangle { <-1, 0, -1>, <-1, 0, 1>, <1, 0, 1> }
  triangle { <-1, 0, -1>, <1, 0, 1>, <1, 0, -1> }
  triangle { <-0.5, 0.25, 0.5>, <0.5, 2.25, 2.5>, <1, 1.75, 2.75> }
  triangle { <-0.5, 0.25, 0.5>, <1, 1.75, 2.75>, <0, -0.25, 0.75> }
disc { <0, 0, 0>, <0, 1, 0>, 1, 0 texture { front_0 } interior_texture { back_0 } }
disc { <0.5, 0.25, -0.5>, <1, 2, -3>, 0.75, 0 texture { front_0 } interior_texture { back_0 } }
disc { <0, 0, 0>, <0, 1, 0>, 1, 0.5 texture { front_0 } interior_texture { back_0 } }
disc { <0.5, 0.25, -0.5>, <-1, 2, 3>, 0.375, 0.25 texture { front_0 } interior_texture { back_0 } }
cylinder { <0, -1, 0>, <0, 1, 0>, 1 open texture { front_0 } interior_texture { back_0 } }
cylinder { <0, 0.25, 0>, <0, 0.5, 0>, 0.375 open texture { back_0 } interior_texture { front_0 } }
cylinder { <0, -0.5, 0>, <0, 0.75, 0>, 0.5 open texture { front_0 } interior_texture { back_0 } }
disc { <0, -0.5, 0>, <-0, -1, -0>, 0.5, 0 texture { front_0 } interior_texture { back_0 } }
disc { <0, 0.75, 0>, <0, 1, 0>, 0.5, 0 texture { front_0 } interior_texture { back_0 } }
sphere { <-1, -0.25, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
sphere { <-0.75, -0.1875, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
sphere { <-0.5, -0.125, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
sphere { <-0.25, -0.0625, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
sphere { <0, 0, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
sphere { <0.25, 0.0625, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
sphere { <0.5, 0.125, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
sphere { <0.75, 0.1875, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
sphere { <1, 0.25, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
sphere { <1.25, 0.3125, 1>, 0.1 texture { front_0 } interior_texture { back_0 } }
disc { <0, -1, 0>, <-0, -1, -0>, 1, 0 texture { front_0 } interior_texture { back_0 } }
disc { <0, 1, 0>, <0, 1, 0>, 1, 0 texture { front_0 } interior_texture { back_0 } }
disc { <0, 0.25, 0>, <-0, -1, -0>, 0.75, 0 texture { front_0 } interior_texture { back_0 } }
disc { <0, 0.5, 0>, <0, 1, 0>, 0.75, 0 texture { front_0 } interior_texture { back_0 } }
cylinder { <0, 0.25, 0>, <0, 0.5, 0>, 0.75 open texture { front_0 } interior_texture { back_0 } }
disc { <0, 0, 0>, <-0, -1, -0>, 1, 0 texture { front_0 } interior_texture { back_0 } }
cone { <0, 0, 0>, 1, <0, 2, 0>, 0 open texture { front_0 } interior_texture { back_0 } }
disc { <0, 0, 0>, <-0, -1, -0>, 0.75, 0 texture { front_0 } interior_texture { back_0 } }
cone { <0, 0, 0>, 0.75, <0, 0.25, 0>, 0 open texture { front_0 } interior_texture { back_0 } }
disc { <0, -0.25, 0>, <-0, -1, -0>, 1, 0.5 texture { front_0 } interior_texture { back_0 } }
disc { <0, 0.25, 0>, <0, 1, 0>, 1, 0.5 texture { front_0 } interior_texture { back_0 } }
cylinder { <0, -0.25, 0>, <0, 0.25, 0>, 0.5 open texture { back_0 } interior_texture { front_0 } }
cylinder { <0, -0.25, 0>, <0, 0.25, 0>, 1 open texture { front_0 } interior_texture { back_0 } }
disc { <0, 0.5, 0>, <-0, -1, -0>, 0.875, 0.75 texture { front_0 } interior_texture { back_0 } }
disc { <0, 2, 0>, <0, 1, 0>, 0.875, 0.75 texture { front_0 } interior_texture { back_0 } }
cylinder { <0, 0.5, 0>, <0, 2, 0>, 0.75 open texture { back_0 } interior_texture { front_0 } }
cylinder { <0, 0.5, 0>, <0, 2, 0>, 0.875 open texture { front_0 } interior_texture { back_0 } }
cone { <0, 0, 0>, 0.7, <0, 0.3, 0>, 0 open texture { back_0 } interior_texture { front_0 } }
quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 clipped_by { plane { <0, 1, 0>, 1 } } texture { front_0 } interior_texture { back_0 } }
quadric { <1, 0, 1>, <0, 0, 0>, <0, -1.633333333333333, 0>, 0 clipped_by { plane { <0, 1, 0>, 0.3 } } texture { back_0 } interior_texture { front_0 } }
torus { 2, 0.5 sturm texture { front_0 } interior_texture { back_0 } }
torus { 1, 0.9 sturm texture { front_0 } interior_texture { back_0 } }
box { <-1, -0.5, -1>, <0.5, 1, 1> matrix <-1, 0, 0, -0.5, 1, 0, 0, 0.25, 1, 0, 0, 0> texture { front_0 } interior_texture { back_0 } }
sphere { <0, 0, 0>, 1 matrix <2, 0, 0, 0, 2.121320343559643, -2.1213203435596424, 0, 0.7071067811865475, 0.7071067811865476, 0, 1, 0> texture { front_0 } interior_texture { back_0 } }
sphere { <-0.10633421867322945, -0.9981541500680957, 0.8220013856304158>, 0.3 texture { front_0 } interior_texture { back_0 } }
sphere { <-0.10633421867322945, -0.9981541500680957, 0.8220013856304158>, 0.05 texture { front_0 } interior_texture { back_0 } }
sphere { <0.670973833280273, 0.5393196372320801, 0.18879228839874362>, 0.05 texture { front_0 } interior_texture { back_0 } }
(38 lines)
  triangle { <2.5999999046325684, 0, 0>, <2.565704822540283, 0.19509032368659973, 0.2983625531196594>, <2.6378941535949707, 0.3746037185192108, 0.22463659942150116> }
  triangle { <2.5999999046325684, 0, 0>, <2.6378941535949707, 0.3746037185192108, 0.22463659942150116>, <2.6535897254943848, 0.17888543009757996, -0.08944273740053177> }
  triangle { <2.6535897254943848, 0.17888543009757996, -0.08944273740053177>, <2.6378941535949707, 0.3746037185192108, 0.22463659942150116>, <2.7951278686523438, 0.5060166120529175, 0.19497060775756836> }
  triangle { <2.6535897254943848, 0.17888543009757996, -0.08944273740053177>, <2.7951278686523438, 0.5060166120529175, 0.19497060775756836>, <2.799999952316284, 0.3098386526107788, -0.15491937100887299> }
(2310 lines)

== material (25 lines stand above)
  max_trace_level 3
#declare front_1 = texture { pigment { rgb <1, 0.5, 0.25> } finish { ambient 0.25 diffuse 0.75/pi } }
#declare back_1 = texture { pigment { rgb <1, 0.5, 0.25> } finish { ambient 0.25 diffuse 0/pi } }
#declare front_2 = texture { pigment { rgb <0.5, 0.6, 0.1> } finish { ambient 0.25 diffuse 0.5/pi } }
#declare back_2 = texture { pigment { rgb <0.5, 0.6, 0.1> } finish { ambient 0.25 diffuse 0/pi } }
#declare front_3 = texture { pigment { rgb <0.5, 0.6, 0.1> } finish { ambient 0.25 diffuse 0.5/pi reflection { rgb <0.225, 0.25, 0.225> } } }
#declare back_3 = texture { pigment { rgb <0.5, 0.6, 0.1> } finish { ambient 0.25 diffuse 0/pi reflection { rgb <0.225, 0.25, 0.225> } } }
#declare front_4 = texture { pigment { rgb <1, 1, 0.5> } finish { ambient 0 diffuse 0/pi emission exposure*2.5 } }
#declare back_4 = texture { pigment { rgb <0, 0, 0> } finish { ambient 0 diffuse 0/pi } }
#declare front_5 = texture { pigment { rgb 0 transmit 0.9 } finish { ambient 0 diffuse 0 reflection { rgb <0.1, 0.1, 0.1> } } }
#declare back_5 = texture { pigment { rgb 0 transmit 0.9 } finish { ambient 0 diffuse 0 reflection { rgb <0.1, 0.1, 0.1> } } }
#declare front_6 = texture { pigment { rgb 0 transmit 0.9 } finish { ambient 0 diffuse 0 reflection { rgb <0.1, 0.1, 0.1> } } }
#declare back_6 = texture { pigment { rgb 0 transmit 0.9 } finish { ambient 0 diffuse 0 reflection { rgb <0.1, 0.1, 0.1> } } }
#declare front_7 = texture { pigment { rgb 0 transmit 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }
#declare back_7 = texture { pigment { rgb 0 transmit 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel } conserve_energy } }
sphere { <0, 5, 0>, 1 texture { front_1 } interior_texture { back_1 } }
sphere { <3, 5, 0>, 1 texture { front_2 } interior_texture { back_2 } }
sphere { <6, 5, 0>, 1 texture { front_3 } interior_texture { back_3 } }
sphere { <9, 5, 0>, 1 texture { front_4 } interior_texture { back_4 } }
sphere { <12, 5, 0>, 1 texture { front_5 } interior_texture { back_5 } interior { ior 1.5 } no_shadow }
sphere { <12, 5, 0>, 1 texture { pigment { rgb 0 } } no_image no_reflection }
sphere { <15, 5, 0>, 1 texture { front_6 } interior_texture { back_6 } interior { ior 0.75 } no_shadow }
sphere { <15, 5, 0>, 1 texture { pigment { rgb 0 } } no_image no_reflection }
sphere { <18, 5, 0>, 1 texture { front_7 } interior_texture { back_7 } interior { ior 1.5 } no_shadow }
sphere { <18, 5, 0>, 1 texture { pigment { rgb 0 } } no_image no_reflection }

== light (25 lines stand above)
  ambient_light rgb exposure*<0.25, 0.125, 0.1875>
light_source { <702246.8831767834, 702246.8831767834, 117041.14719613057> rgb exposure*<2, 2, 2> parallel point_at <0, 0, 0> }
light_source { <10, 15, 20> rgb exposure*<3, 1.5, 0> }
light_source { <10, 15, 20> rgb exposure*<299999999999.99994, 149999999999.99997, 0> fade_distance 0.000031622776601683795 fade_power 2 }

== texture (38 lines stand above)
#declare front_1 = texture { pigment { function { (1+2*abs(mod(floor(x/0.75+-0.000187453738)+floor(y/0.75+-0.000187453738)+floor(z/0.75+-0.000187453738),2)))/6 } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0.1, 0.4, 0.8>] [2/3 rgb <0.1, 0.4, 0.8>] [2/3 rgb <1, 1, 1>] } } finish { ambient 0.1 diffuse 0.5/pi } }
#declare back_1 = texture { pigment { function { (1+2*abs(mod(floor(x/0.75+-0.000187453738)+floor(y/0.75+-0.000187453738)+floor(z/0.75+-0.000187453738),2)))/6 } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0.1, 0.4, 0.8>] [2/3 rgb <0.1, 0.4, 0.8>] [2/3 rgb <1, 1, 1>] } } finish { ambient 0.1 diffuse 0/pi } }
#declare front_2 = texture { pigment { function { (1+2*abs(mod(floor(x/0.5+0)+floor(z/0.5+0),2)))/6 } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0.5, 0.75, 0.5>] [2/3 rgb <0.5, 0.75, 0.5>] [2/3 rgb <1, 1, 1>] } } finish { ambient 0.1 diffuse 0.5/pi } }
#declare back_2 = texture { pigment { function { (1+2*abs(mod(floor(x/0.5+0)+floor(z/0.5+0),2)))/6 } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0.5, 0.75, 0.5>] [2/3 rgb <0.5, 0.75, 0.5>] [2/3 rgb <1, 1, 1>] } } finish { ambient 0.1 diffuse 0/pi } }
#declare front_3 = texture { pigment { function { select(min(x/0.5-floor(x/0.5),1-(x/0.5-floor(x/0.5)),z/0.5-floor(z/0.5),1-(z/0.5-floor(z/0.5)))-0.0625,5/6,(1+2*abs(mod(floor(x/0.5+0)+floor(z/0.5+0),2)))/6) } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0.5, 0.75, 0.5>] [2/3 rgb <0.5, 0.75, 0.5>] [2/3 rgb <0, 0, 0>] } } finish { ambient 0.1 diffuse 0.5/pi } }
#declare back_3 = texture { pigment { function { select(min(x/0.5-floor(x/0.5),1-(x/0.5-floor(x/0.5)),z/0.5-floor(z/0.5),1-(z/0.5-floor(z/0.5)))-0.0625,5/6,(1+2*abs(mod(floor(x/0.5+0)+floor(z/0.5+0),2)))/6) } color_map { [1/3 rgb <1, 1, 1>] [1/3 rgb <0.5, 0.75, 0.5>] [2/3 rgb <0.5, 0.75, 0.5>] [2/3 rgb <0, 0, 0>] } } finish { ambient 0.1 diffuse 0/pi } }
#declare front_4 = texture { pigment { rgb <0, 0, 0> } finish { ambient 0.1 diffuse 0.5/pi } }
#declare back_4 = texture { pigment { rgb <0, 0, 0> } finish { ambient 0.1 diffuse 0/pi } }
  texture { back_1 } interior_texture { front_1 } }
  texture { back_2 } interior_texture { front_2 } }
  texture { back_3 } interior_texture { front_3 } }
  texture { back_4 pigment { rgb <0.7328564099515954, 0.21779406012860203, 0.9804271225216387> } } interior_texture { front_4 pigment { rgb <0.7328564099515954, 0.21779406012860203, 0.9804271225216387> } } }

== camera (24 lines stand above)
  orthographic
  direction <-0, -0, -1>

== camera (25 lines stand above)
  direction <-0, -0, -500>

== camera (23 lines stand above)
  fisheye angle 120
  right <1, 0, 0>
  up <0, 1, 0>

== camera (23 lines stand above)
  spherical angle 84, 56
  right <-1, -0, -0>
  up <-0, -1, -0>

== camera (24 lines stand above)
  cylinder 1 angle 180
  up <0, 1.9999999999999998, 0>
