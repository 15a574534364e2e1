//! Mistakes of instances (Suffern, ch. 21).

use std::path::Path;
use std::sync::Arc;

use groundtruth::kinds::{Custom, Resources};
use groundtruth::math::{Aabb, Normal, Ray, Span, Transform, Vector};
use groundtruth::scene::Scene;
use groundtruth::shapes::{
    Candidate, Context, Instance, Kind, Role, SampledSurface, Sampling, Shape, Surface, Within,
};

use super::changed;
use crate::mistakes::Mistake;
use crate::mistakes::places::any;

pub(super) const ALL: &[Mistake] = &[Mistake::scene("normal-by-matrix", changed_instances)];

/// An instance whose shading normal is `M n'` instead of `(M⁻¹)ᵀ n'`.
#[derive(Debug)]
struct Wrong {
    instance: Arc<dyn Shape>,
    transform: Transform,
}

impl Wrong {
    /// `n' = Mᵀ n`, up to its length, so that `M n' = M Mᵀ n`.
    fn normal(&self, n: Normal) -> Normal {
        let rows = self.transform.rows();
        let n = Vector::from(n).to_array();
        let column = |j: usize| (0..3).map(|i| rows[i][j] * n[i]).sum();
        let inner = Vector::new(column(0), column(1), column(2));
        Normal::new(self.transform.vector(inner)).expect("the matrix is not singular")
    }
}

impl Shape for Wrong {
    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = self.instance.surface(ray, at);
        Surface { shading: self.normal(surface.shading), ..surface }
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        Within::Nested(&*self.instance, *at, Role::Same)
    }

    as_in! { instance,
        fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate>;
        fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64>;
        fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate>;
        fn material_without_uv(&self, own: u32, needs_uv: &dyn Fn(u32) -> bool) -> Option<u32>;
        fn sampled(&self, sampling: Sampling) -> Option<Box<dyn SampledSurface>>;
        fn bounds(&self) -> Aabb;
        fn leaves(&self) -> u64;
    }
}

/// The shape with the mistake, if it is an instance; so are the normals of the instances in it.
fn changed_shape(instance: &Instance, context: &mut Context) -> Option<Kind> {
    let transform = Transform::from_steps(&instance.transform).ok()?;
    let of = match &*instance.of {
        Kind::Instance(inner) => changed_shape(inner, context)?,
        other => other.clone(),
    };
    let copy = Kind::from(Instance { of: Box::new(of), ..instance.clone() });
    let instance = copy.build(context).ok()?;
    Some(Kind::Custom(Custom(Arc::new(Wrong { instance, transform }))))
}

/// Instances whose parts name materials of their own, and those within compounds, stay as they are.
fn changed_instances(scene: &Scene, folder: &Path) -> Option<Scene> {
    let mut context = Context::new(Resources::new(folder), scene.accel);
    changed(scene, |scene| {
        any(scene.objects.iter_mut().filter_map(|object| {
            let Kind::Instance(instance) = &object.shape else { return None };
            object.shape = changed_shape(instance, &mut context)?;
            Some(())
        }))
    })
}
