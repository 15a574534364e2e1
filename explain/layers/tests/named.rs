//! Names of layers.

use layers::{KINDS, Layer};

use super::scenes::named;

/// Law: each layer of a scene is found by the name that it prints, and has as many channels as its kind, none of which
/// another has. Oracle: the list itself, read back.
#[test]
fn names_are_read_as_they_are_printed() {
    for scene in ["ch18/rectangle", "ch28/glass-sphere"] {
        let (_, world) = named(scene, 8, 1);
        let layers = Layer::of_scene(&world);
        let mut channels: Vec<String> = Vec::new();
        for layer in &layers {
            assert_eq!(Layer::named(&layer.to_string(), &world).as_ref(), Ok(layer));
            assert_eq!(layer.channels().len(), layer.kind().channels.len());
            channels.extend(layer.channels());
        }
        let count = channels.len();
        channels.sort();
        channels.dedup();
        assert_eq!(channels.len(), count, "two layers with one channel");
        assert!(layers.len() > KINDS.len(), "{scene}: lights, lobes and depths");
    }
}

/// Law: a name that is none says which there are. Oracle: mistyped names and what they mean, by hand.
#[test]
fn mistyped_names_get_a_suggestion() {
    let (_, world) = named("ch28/glass-sphere", 8, 1);
    for (name, hint) in [
        ("normals", "did you mean `normal`"),
        ("distanse", "did you mean `distance`"),
        ("lobe:lambertan", "did you mean `lambertian`"),
        ("lobe", "lobe:NAME"),
        ("light:nobody", "light:NAME"),
        ("depth", "tree-depth"),
        ("depth:x", "depth:N"),
        ("depth:4000", "from 0 to"),
        ("normal:2", "written as normal"),
        ("", "there are picture, normal"),
    ] {
        let error = Layer::named(name, &world).expect_err(name);
        assert!(error.contains(hint), "{name}: {error}");
    }
    let lobe = Layer::named("lobe:Fresnel reflector", &world).expect("as the tree says it");
    assert_eq!(lobe.to_string(), "lobe:fresnel_reflector");
}
