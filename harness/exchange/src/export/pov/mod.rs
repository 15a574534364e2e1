//! The scene language of POV-Ray 3.7.
//!
//! Its formulas are read from its documentation ("Scene Description Language") and from its source, `trace.cpp` of
//! version 3.7; each factor is derived where it is written. Points, vectors and colours are written as they are: a
//! scene language is left-handed or right-handed only where it turns something itself, and nothing here is turned
//! there. Camera axes and matrices are given in full.

mod camera;
mod glass;
mod lights;
mod materials;
mod shapes;
mod text;
mod textures;
mod walk;

use std::collections::BTreeMap;
use std::path::Path;

use groundtruth::background::Background;
use groundtruth::printable;
use groundtruth::scene::{Image, Light, Scene, Tracer};
use groundtruth::shapes::Kind;

use super::leaves::Leaves;
use super::target::{ExportLanguage, Written};
use super::{AnyKind, Exported, How, Target, writer};
use text::rgb;
use walk::Body;

/// A scene being written.
type Writer<'a> = writer::Writer<'a, Pov>;

/// What is written of it.
#[derive(Default)]
struct Pov {
    /// How many triangles are written.
    triangles: u64,
    /// The bodies of glass that are still to be written.
    bodies: BTreeMap<Body, Vec<glass::DielectricPart>>,
    text: String,
}

/// POV-Ray sends one ray through the centre of each pixel (`-A`: no more where neighbours differ) and writes linear values
/// (`File_Gamma=1`) of 16 bits (`+FN16`).
pub(super) const LANGUAGE: ExportLanguage = ExportLanguage {
    name: "POV-Ray",
    program: "povray",
    version: &["--version"],
    missing: None,
    files: ["scene.pov", "scene.png"],
    arguments: "+Iscene.pov +Oscene.png -A -D +FN16 File_Gamma=1.0 +W{width} +H{height}",
    script: None,
    write,
    how,
    apart: |kind| match kind {
        Kind::Instance(_) => Some(How::Instance("triangles have their corners transformed")),
        Kind::Lattice(_) => Some(How::Instance("each copy")),
        Kind::Compound(_)
        | Kind::SolidCylinder(_)
        | Kind::SolidCone(_)
        | Kind::ThickRing(_)
        | Kind::RandomSpheres(_) => Some(How::Mesh("its parts")),
        _ => None,
    },
    is_noiseless: |_| true,
    is_single: false,
};

fn write([name, _]: [&str; 2], leaves: &Leaves<'_>, scene: &Scene, folder: &Path) -> Written {
    let mut head = Writer::new(Target::Pov, scene, folder, Pov::default());
    head.refuse_tracer();
    head.refuse_settings();
    head.header(name);
    head.globals();
    head.camera();
    head.lights();
    head.materials(&leaves.materials());
    head.objects(leaves);
    head.refuse_attenuated_shadows();
    if head.unsupported.is_empty() && !head.own.bodies.is_empty() {
        head.walk(folder);
    }
    head.bodies();
    match head.unsupported.is_empty() {
        true => Ok(Exported { text: head.own.text, files: Vec::new() }),
        false => Err(head.unsupported),
    }
}

/// How a kind is exported: what is written of it in this scene.
fn how(scene: &Scene, kind: &AnyKind) -> How {
    let mut writer = Writer::new(Target::Pov, scene, "".as_ref(), Pov::default());
    match kind {
        AnyKind::Shape(_) => writer.shape(&Leaves::of(scene, Target::Pov).all[0]),
        AnyKind::Material(it) => writer.side("", it).0,
        AnyKind::Light(it) => writer.light("", &Light::new("", it.clone())),
        AnyKind::Texture(it) => writer.texture("", it).0,
        AnyKind::Camera(_) => writer.camera(),
    }
}

impl Writer<'_> {
    fn line(&mut self, line: &str) {
        self.own.text += line;
        self.own.text.push('\n');
    }

    fn refuse_tracer(&mut self) {
        if !matches!(self.scene.tracer, Tracer::RayCast | Tracer::Whitted(_)) {
            let problem = "a path tracer; POV-Ray adds up direct light and mirror images, as ray_cast and whitted do";
            self.refuse("tracer", problem);
        }
    }

    fn header(&mut self, name: &str) {
        let Image { width, height, .. } = self.scene.image;
        let [name, about] = [name, &self.scene.about].map(printable::text);
        self.line(&format!(
            "// {name}: {about}\n\
             // Linear radiance, one ray through the centre of each pixel:\n\
             //   povray +Ithis.pov +Othis.png +W{width} +H{height} -A -D +FN16 File_Gamma=1.0\n\
             #version 3.7;"
        ));
    }

    /// What holds for the whole picture.
    ///
    /// - `exposure` multiplies every source of light, hence every pixel: all that POV-Ray computes here is linear in
    ///   them.
    /// - `ambient_light`: POV-Ray adds pigment · ambient · ambient_light to a surface, we ρa · Σ ls · color with
    ///   ρa = ka · cd. So it is the sum of the ambient lights, and `ambient` is ka.
    /// - `max_trace_level`: POV-Ray stops where the number of edges before a ray is at least this number, we where it is
    ///   above `max_depth`: one more.
    /// - `adc_bailout 0`: no ray is left out because its weight is small.
    fn globals(&mut self) {
        let ambient = lights::ambient(self.scene);
        let depth = match self.scene.tracer {
            Tracer::Whitted(whitted) => whitted.max_depth,
            _ => 0,
        };
        let (exposure, ambient) = (text::number(self.scene.camera.exposure_time), rgb(ambient));
        let level = depth + 1;
        self.line(&format!(
            "#declare exposure = {exposure};\n\
             global_settings {{\n  assumed_gamma 1\n  ambient_light rgb exposure*{ambient}\n  \
             max_trace_level {level}\n  adc_bailout 0\n}}"
        ));
        if let Background::Color(color) = self.scene.background {
            self.line(&format!("background {{ rgb exposure*{} }}", rgb(color)));
        }
    }
}
