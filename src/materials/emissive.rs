//! The emissive material (Suffern, ch. 18 and 24): a surface that shines.

use super::matte::{self, Matte};
use super::{Made, Material, Response, Specification, TexturedField, made, textured, within};
use crate::kinds::{self, Resources};
use crate::materials::Emission;
use crate::textures::{Amount, Paint, TexturePoint};

/// Radiance `ls · ce` in every direction on the outer side; black on the inner, unless the material
/// is two-sided.
#[kind]
pub struct Emissive {
    /// Multiplies the colour; not negative.
    #[default(Amount::one())]
    pub ls: Amount,
    /// The colour of the light it sends out.
    #[default(kinds::white())]
    pub ce: Paint,
    /// The fields of `matte`, for a surface that reflects as well; nothing if left out.
    pub matte: Option<Matte>,
}

impl Emissive {
    /// A surface that shines and reflects nothing.
    pub fn new(ls: impl Into<Amount>, ce: impl Into<Paint>) -> Self {
        Self { ls: ls.into(), ce: ce.into(), matte: None }
    }
}

#[derive(Debug)]
struct Shining {
    emission: Emission,
    matte: Option<matte::MatteMaterial>,
}

impl Specification for Emissive {
    const FORMULA: &'static str = "\
        adds ls · ce towards every viewer on the side that the normal points to, at any distance \
        and angle. With `matte` in it, also ρa and f of `matte`; otherwise both are 0.";

    fn make(&self, resources: &mut Resources) -> Made {
        let ls = self.ls.build("ls", resources)?;
        let ce = self.ce.build("ce", resources)?;
        let matte = self.matte.as_ref().map(|matte| matte.check(resources)).transpose();
        let matte = matte.map_err(|e| e.inside("matte"))?;
        made(Shining { emission: Emission { ls, ce }, matte })
    }
}

impl Material for Shining {
    fn respond(&self, at: &TexturePoint<'_>, cos_o: f64, response: &mut Response) {
        if let Some(matte) = &self.matte {
            matte.respond(at, cos_o, response);
        }
    }

    fn emission(&self) -> Option<&Emission> {
        Some(&self.emission)
    }

    fn textures(&self, at: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        let Emission { ls, ce } = &self.emission;
        let mut all = textured([("ls", ls.texture()), ("ce", ce.texture())]);
        all.extend(self.matte.iter().flat_map(|matte| within("matte", matte, at)));
        all
    }
}
