//! Chapter 4: antialiasing.

use super::List;
use groundtruth::background::{Background, Pattern, Sinusoid};
use groundtruth::cameras::{Orthographic, Pinhole, Viewpoint};
use groundtruth::filters::{Box, Gaussian, Kind as Filter, Mitchell, Tent};
use groundtruth::math::{Point, Vector};
use groundtruth::samplers::{
    CorrelatedMultiJittered, Hammersley, Jittered, Kind as Sampler, MultiJittered, NRooks, Random,
    Regular, Sobol,
};
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Scene};

pub const SCENES: List = &[
    ("ch04/sinusoid", || sinusoid("one sample in the middle of each pixel", Regular {}, 1)),
    ("ch04/sinusoid-regular", || sinusoid("25 regular samples", Regular {}, 25)),
    ("ch04/sinusoid-random", || sinusoid("25 random samples", Random {}, 25)),
    ("ch04/sinusoid-jittered", || sinusoid("25 jittered samples", Jittered {}, 25)),
    ("ch04/sinusoid-n-rooks", || sinusoid("25 n-rooks samples", NRooks {}, 25)),
    ("ch04/sinusoid-multi-jittered", || {
        sinusoid("25 multi-jittered samples", MultiJittered {}, 25)
    }),
    ("ch04/sinusoid-hammersley", || {
        sinusoid("25 Hammersley samples", Hammersley { shifted: false }, 25)
    }),
    ("ch04/sinusoid-correlated-multi-jittered", || {
        sinusoid("25 correlated multi-jittered samples", CorrelatedMultiJittered {}, 25)
    }),
    ("ch04/sinusoid-sobol", || sinusoid("32 scrambled Sobol samples", Sobol {}, 32)),
    ("ch04/jagged-sphere", || ball("figure 4.4a: a sphere with one sample a pixel", 1)),
    ("ch04/smooth-sphere", || ball("figure 4.4b: a sphere with 16 samples a pixel", 16)),
    ("ch04/checker", || checker("figure 4.8: a checker to the horizon, 64 samples", Box {}.into())),
    ("ch04/checker-tent", || {
        checker("figure 4.8's checker through a tent filter", Tent { radius: 1.0 }.into())
    }),
    ("ch04/checker-gaussian", || {
        let filter = Gaussian { sigma: 0.5, radius: 1.5 };
        checker("figure 4.8's checker through a Gaussian filter", filter.into())
    }),
    ("ch04/checker-mitchell", || {
        let filter = Mitchell { b: 1.0 / 3.0, c: 1.0 / 3.0 };
        let mut scene = checker("figure 4.8's checker through Mitchell's filter", filter.into());
        // negative weights amplify noise, so this uses the sampler with the least noise
        scene.image.sampler = Some(MultiJittered {}.into());
        scene
    }),
];

/// Figure 4.2: the grey `(1 + sin(x² y²))/2` over `[0, 10.83]²`.
fn sinusoid(sampling: &str, sampler: impl Into<Sampler>, samples: u32) -> Scene {
    const SIDE: f64 = 10.83;
    let center = point(0.5 * SIDE, 0.5 * SIDE, 0.0);
    let eye = center + 100.0 * Vector::Z;
    let camera = Viewpoint::new(eye, center, Orthographic { zoom: 1.0 });
    let sampler = Some(sampler.into());
    let image = Image { pixel_size: SIDE / 512.0, samples, sampler, ..Image::new(512, 512) };
    let about = format!("figure 4.2: sin(x² y²), {sampling}: false circles where it aliases");
    let mut scene = Scene::new(&about, image, camera);
    scene.background = Background::Pattern(Pattern::Sinusoid(Sinusoid { unit: 1.0 }));
    scene
}

fn ball(about: &str, samples: u32) -> Scene {
    let camera = Viewpoint::new(point(0.0, 0.0, 100.0), Point::ORIGIN, Orthographic { zoom: 1.0 });
    let image = Image { pixel_size: 0.1, samples, ..Image::new(100, 100) };
    let mut scene = Scene::new(about, image, camera);
    scene.lights.push(ambient(1.0));
    scene.lights.push(point_light("lamp", point(100.0, 100.0, 200.0), 2.0).without_shadows());
    let yellow = matte(0.2, 0.8, rgb(1.0, 1.0, 0.0));
    add(&mut scene, "sphere", sphere(Point::ORIGIN, 5.0), yellow);
    scene
}

fn checker(about: &str, filter: Filter) -> Scene {
    let lens = Pinhole { distance: 175.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(100.0, 500.0, 100.0), point(0.0, 450.0, 0.0), lens);
    let sampler = Some(Jittered {}.into());
    let image = Image { samples: 64, sampler, filter, ..Image::new(300, 200) };
    let mut scene = Scene::new(about, image, camera);
    scene.background = grey(0.25).into();
    scene.lights.push(ambient(1.0));
    scene.lights.push(directional("sun", Vector::Y, 4.0).without_shadows());
    let squares = checker3d(250.0, groundtruth::rgb::Rgb::BLACK, groundtruth::rgb::Rgb::WHITE);
    add(&mut scene, "ground", ground(0.0), matte(0.5, 0.35, squares));
    scene
}
