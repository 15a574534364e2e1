//! Chapter 29: images on surfaces and as skies.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | mappings from points to texture coordinates | each mapping undoes the parametrisation of its generic object: of the sphere u = φ/2π and v = 1 − θ/π at `(sinθ sinφ, cosθ, sinθ cosφ)`, likewise of square, cylinder, hemisphere and light probe | `mappings::mappings_invert_the_parametrisation` |
//! |  | on a sphere +z is u = 0, +x a quarter, −z a half, −x three quarters, the equator is v = ½, and the north pole is the top row | `mappings::the_sphere_is_mapped_as_in_the_book` |
//! |  | around an object there is one seam, at φ = 0: a step of a thousandth of a turn changes u by as much, but across the seam by 1 less | `mappings::there_is_one_seam` |
//! |  | texture coordinates are within 0 and 1, on the object and within rounding of it, at poles and on seams too | `mappings::coordinates_are_between_0_and_1` |
//! | light probes | the centre of a light probe is +z, the plane z = 0 is a circle of half the radius, and −z is the rim; the panoramic kind has z the other way round | `mappings::a_light_probe_is_mapped_by_the_angle_to_its_axis` |
//! | fig. 29.16, a light probe seen by a fisheye of 360° | a camera that maps directions as an image does shows that image: a fisheye of 360° shows a panoramic light probe as it is along −z, and a light probe mirrored along +z; a panorama of 360° × 180° a spherical map mirrored | `sky::a_fisheye_all_around_shows_the_image_of_a_light_probe` |
//! | from texture coordinates to texels | by the book's rule a texel covers 1/(n − 1), and the last column and row are reached at 1 only | `texels::the_books_rule_reaches_the_last_texel_at_1_only` |
//! |  | by the even rule each texel covers 1/n of the image, and rows count from the bottom | `texels::each_texel_covers_an_equal_part_by_the_even_rule` |
//! | fig. 29.19, bilinear interpolation | bilinear look-up is the sum of tents around the centres of the texels, by either rule and at every border; therefore it is exact at centres, reproduces affine images and stays between its neighbours | `texels::bilinear_look_up_is_a_sum_of_tents` |
//! | spatially varying materials and lights | an image of one colour is the constant of that colour, bit for bit, in every field of every material, nearest and bilinear | `materials::an_image_of_one_colour_is_the_constant` |
//! |  | a lamp emits the colour of its image at the sampled point, by the coordinates of a mesh or by a mapping, also in an instance | `materials::a_lamp_with_an_image_gives_the_light_of_its_parts` |
//! |  | turning a textured instance about y by a column's width shifts its image by a column; the texture goes with the object | `materials::a_turned_globe_shows_the_next_column` |
//! | texture coordinates of triangle meshes | a mesh's texture coordinates are those given at its corners, and affine between | `materials::an_image_lies_on_a_mesh_by_its_corners` |
//! | fig. 29.27, a sky by an image | the colour seen in a direction is that of its texel, times `ls`; below the horizon of a hemispherical sky it is black | `sky::each_direction_shows_its_texel` |
//!
//! Beyond the book: 1 in `mappings`, 2 in `materials`, 1 in `one_texel`, 4 in `sky`, 2 in `sky_light`, 4 in `texels`.

mod mappings;
mod materials;
mod one_texel;
mod sky;
mod sky_light;
mod texels;

use std::io::Write;

use groundtruth::kinds::Resources;
use groundtruth::textures::{Image, Kind, Mapping, Texture};

use crate::prelude::*;

/// A linear image whose texel at a column from the left and a row from the bottom has this colour, in steps
/// of 1/65535; the file is deleted when the value is dropped.
pub fn image_file(
    [width, height]: [u32; 2],
    color: impl Fn(u32, u32) -> [u16; 3],
) -> tempfile::NamedTempFile {
    let mut file = tempfile::Builder::new().suffix(".ppm").tempfile().expect("a temporary file");
    let mut bytes = format!("P6\n{width} {height}\n65535\n").into_bytes();
    for from_top in 0..height {
        let row = height - 1 - from_top;
        let texels = (0..width).flat_map(|column| color(column, row));
        bytes.extend(texels.flat_map(u16::to_be_bytes));
    }
    file.write_all(&bytes).expect("room for a small file");
    file
}

/// An image of that file by the surface's own texture coordinates, or a mapping.
pub fn linear(file: &tempfile::NamedTempFile, mapping: Option<Mapping>) -> Image {
    let encoding = Some(formats::images::Encoding::Linear);
    Image { encoding, ..Image::of_file(file.path(), mapping) }
}

fn texture(image: &Image) -> Arc<dyn Texture> {
    Kind::from(image.clone()).build(&mut Resources::default()).expect("an image")
}

/// The colours that an image has at texture coordinates.
pub fn by_uv(image: &Image) -> impl Fn([f64; 2]) -> Rgb + use<> {
    let (texture, surface) = (texture(image), Surface::new(Point::ORIGIN, 0.0, Normal::Y));
    move |uv| texture.color(&TexturePoint::with_uv(&surface, uv))
}

/// The columns and rows that an image names at texture coordinates.
pub fn texel_by_uv(image: &Image) -> impl Fn([f64; 2]) -> [u32; 2] + use<> {
    let (texture, surface) = (texture(image), Surface::new(Point::ORIGIN, 0.0, Normal::Y));
    move |uv| {
        let texel =
            texture.texel(&TexturePoint::with_uv(&surface, uv)).expect("an image has texels");
        [texel.column, texel.row]
    }
}
