//! Vessels of glass with water in them: one surface for each boundary between two media (Suffern,
//! ch. 28). With a surface of the glass and one of the water where they touch, air would be between
//! them.

use std::sync::Arc;

use crate::invalid::Invalid;
use crate::math::Vector;
use crate::shapes::composite::assembly::{Assembly, PartData};
use crate::shapes::solid::edges::moved;
use crate::shapes::{Context, Kind, PartTorus, Shape};

/// The materials of a vessel's boundaries. The first medium of each name is on the inner side, the
/// side that the normals point away from.
#[kind(Default, PartialEq)]
pub struct BoundaryMaterials {
    /// The name of the material between glass and air; the object's if left out.
    pub glass_air: Option<String>,
    /// The name of the material between water and air; the object's if left out.
    pub water_air: Option<String>,
    /// The name of the material between water and glass; the object's if left out.
    pub water_glass: Option<String>,
}

impl BoundaryMaterials {
    /// Builds parts of one boundary each.
    pub(in crate::shapes) fn build(
        &self,
        glass_air: &[Named],
        water_air: &[Named],
        water_glass: &[Named],
        context: &mut Context,
    ) -> Result<Arc<dyn Shape>, Invalid> {
        let boundaries = [
            ("glass_air", glass_air, &self.glass_air),
            ("water_air", water_air, &self.water_air),
            ("water_glass", water_glass, &self.water_glass),
        ];
        let mut all = Vec::new();
        for (boundary, parts, material) in boundaries {
            let material = material.as_deref();
            if let Some(name) = material {
                let checked =
                    context.material(name).map_err(|e| Invalid::field(boundary, e.problem));
                checked.map_err(|e| e.inside("materials"))?;
            }
            all.extend(parts.iter().map(|(name, shape)| PartData { name, material, shape }));
        }
        Ok(Arc::new(Assembly::build("parts", all, None, context)?))
    }
}

/// A part by its name.
type Named = (&'static str, Kind);

/// Part of a meniscus: a torus with its circle of radius `swept` at this height, between angles
/// `theta` around the tube. The water is outside the tube, so the normals point into it.
pub(in crate::shapes) fn meniscus(swept: f64, radius: f64, height: f64, theta: [f64; 2]) -> Kind {
    let (swept_radius, tube_radius, phi) = (swept, radius, [0.0, 360.0]);
    let tube = PartTorus { swept_radius, tube_radius, phi, theta, inward: true };
    moved(tube, height * Vector::Y)
}
