//! Sentences about materials that reflect more light than they receive.

use groundtruth::invalid::shown;
use groundtruth::materials::{Kind, Matte, Phong};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Material, Scene};
use groundtruth::textures::{Amount, Paint};

/// For each material that reflects more light than it receives wherever it is met, a sentence that
/// says so.
pub(super) fn excess(scene: &Scene) -> impl Iterator<Item = String> {
    let note = |material: &Material| {
        // half a millionth more is rounding of the numbers in the file
        let is_excess = |(_, share): &Reflectance| share.max() > 1.0 + 5e-7;
        let (fields, share) = reflectances(&material.recipe).into_iter().find(is_excess)?;
        let (name, share) = (&material.name, shown(share.max()));
        Some(format!(
            "material \"{name}\": {fields} is up to {share}: more light leaves the surface than comes to it \
             (1 is all of it; divide colours of 0 to 255 by 255)"
        ))
    };
    scene.materials.iter().filter_map(note)
}

/// The fields of a material whose product is a share of light, as `kd · cd`, and that share.
type Reflectance = (String, Rgb);

/// The shares of light that are the same at every point.
fn reflectances(kind: &Kind) -> Vec<Reflectance> {
    match kind {
        Kind::Matte(it) => matte(it).collect(),
        Kind::Phong(it) => phong(it).collect(),
        Kind::Reflective(it) => over_phong(mirror(&it.kr, &it.cr), &it.phong),
        Kind::GlossyReflector(it) => over_phong(mirror(&it.kr, &it.cr), &it.phong),
        Kind::Transparent(it) => {
            let refracted = match it.kt {
                Amount::Plain(kt) => Some(("kt".to_owned(), Rgb::grey(kt))),
                Amount::Textured(_) => None,
            };
            over_phong(mirror(&it.kr, &it.cr).into_iter().chain(refracted), &it.phong)
        }
        Kind::Dielectric(it) => over_phong([], &it.phong),
        Kind::Emissive(it) => {
            it.matte.iter().flat_map(|base| within("matte".to_owned(), matte(base))).collect()
        }
        Kind::SphereMaterials(it) => {
            let of = |(i, kind)| within(format!("materials[{i}]"), reflectances(kind));
            it.materials.iter().enumerate().flat_map(of).collect()
        }
        Kind::Custom(_) => Vec::new(),
    }
}

fn matte(Matte { ka, kd, cd }: &Matte) -> impl Iterator<Item = Reflectance> {
    [("ka", ka), ("kd", kd)].into_iter().filter_map(|share| constant(share, ("cd", cd)))
}

fn phong(Phong { ka, kd, cd, ks, cs, .. }: &Phong) -> impl Iterator<Item = Reflectance> {
    let all = [("ka", ka, ("cd", cd)), ("kd", kd, ("cd", cd)), ("ks", ks, ("cs", cs))];
    all.into_iter().filter_map(|(name, share, color)| constant((name, share), color))
}

fn mirror(kr: &Amount, cr: &Paint) -> Option<Reflectance> {
    constant(("kr", kr), ("cr", cr))
}

fn over_phong(own: impl IntoIterator<Item = Reflectance>, base: &Phong) -> Vec<Reflectance> {
    own.into_iter().chain(within("phong".to_owned(), phong(base))).collect()
}

/// The product of a share and a colour, if no texture is among them.
fn constant(share: (&str, &Amount), color: (&str, &Paint)) -> Option<Reflectance> {
    match (share.1, color.1) {
        (Amount::Plain(k), Paint::Plain(c)) => {
            Some((format!("{} · {}", share.0, color.0), *k * *c))
        }
        _ => None,
    }
}

/// The shares of a material that stands in a field of another.
fn within(
    field: String,
    shares: impl IntoIterator<Item = Reflectance>,
) -> impl Iterator<Item = Reflectance> {
    let prefixed = move |(name, share): Reflectance| {
        let names: Vec<String> = name.split(" · ").map(|name| format!("{field}.{name}")).collect();
        (names.join(" · "), share)
    };
    shares.into_iter().map(prefixed)
}
