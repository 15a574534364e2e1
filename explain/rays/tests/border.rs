use super::laws::traced;
use rays::RayVerdict;

/// Law: what differs by the rounding of the program's numbers breaks no law. Oracle: a mirror and its normal rounded to
/// single precision.
#[test]
fn rounding_breaks_no_law() {
    let single = |x: f64| f64::from(x as f32);
    for step in 1..200 {
        let angle = f64::from(step) * 7.5e-3;
        let (sine, cosine) =
            (single(groundtruth::math::sin(angle)), single(groundtruth::math::cos(angle)));
        let lines = [
            format!(
                "{{\"ray\": 0, \"kind\": \"camera\", \"origin\": [{}, {}, 0], \"direction\": [{sine}, -{cosine}, 0], \"t\": 3, \"normal\": [0, 1, 0]}}",
                single(-3.0 * sine),
                single(3.0 * cosine)
            ),
            format!(
                "{{\"ray\": 1, \"parent\": 0, \"kind\": \"reflected\", \"origin\": [0, 0, 0], \"direction\": [{sine}, {cosine}, 0]}}"
            ),
        ];
        let traced = traced(&lines);
        let verdict = RayVerdict::of(traced);
        assert!(!verdict.is_broken(), "at {angle}: {}", verdict.text());
    }
}

/// Law: a finding that follows from another of the same ray does not come first. Oracle: an offset to the wrong side makes a
/// surface block itself.
#[test]
fn what_follows_is_said_so() {
    let lines = [
        r#"{"ray": 0, "kind": "camera", "origin": [0, 2, 0], "direction": [0, -1, 0], "t": 2, "normal": [0, 1, 0], "object": "floor"}"#,
        r#"{"ray": 1, "parent": 0, "kind": "shadow", "light": "bulb", "origin": [0, -0.001, 0], "direction": [4, 3, 0], "end": 1, "t": 0.0003333333333333, "object": "floor"}"#,
    ];
    let traced = traced(&lines.map(str::to_owned));
    let verdict = RayVerdict::of(traced);
    assert_eq!(verdict.first().map(|(law, ..)| law.name), Some("starts-at-hit"));
    let own = verdict.asked.iter().find(|(law, _)| law.name == "not-its-own-start");
    let follows =
        own.and_then(|(_, asked)| asked.findings.first()).and_then(|finding| finding.follows);
    assert_eq!(follows, Some(1));
}

/// Law: of directions and hits that are wrong on different paths the one nearest to the camera is told first. Oracle: a camera ray whose
/// point is off it, and, in another sample, a ray that goes straight on from a mirror.
#[test]
fn what_is_nearest_to_the_camera_comes_first() {
    let camera = r#""ray": 0, "kind": "camera", "origin": [-3, 4, 0], "direction": [0.6, -0.8, 0], "t": 5, "normal": [0, 1, 0]"#;
    let lines = [
        format!(r#"{{"sample": 0, {camera}, "point": [0, 0, 0]}}"#),
        r#"{"sample": 0, "ray": 1, "parent": 0, "kind": "reflected", "origin": [0, 0, 0], "direction": [0.6, -0.8, 0]}"#.to_owned(),
        format!(r#"{{"sample": 1, {camera}, "point": [0, 0, 1]}}"#),
    ];
    let verdict = RayVerdict::of(traced(&lines));
    assert_eq!(verdict.first().map(|(law, ..)| law.name), Some("hit-on-ray"));
}

/// Law: what is wrong with how a ray leaves follows from what is wrong with the hit that it leaves. Oracle: a normal of length 2, and a
/// ray mirrored about it.
#[test]
fn a_wrong_hit_comes_before_what_leaves_it() {
    let lines = [
        r#"{"ray": 0, "kind": "camera", "origin": [-3, 4, 0], "direction": [0.6, -0.8, 0], "t": 5, "normal": [0, 2, 0]}"#,
        r#"{"ray": 1, "parent": 0, "kind": "reflected", "origin": [0, 0, 0], "direction": [0.6, 5.6, 0]}"#,
    ];
    let verdict = RayVerdict::of(traced(&lines.map(str::to_owned)));
    assert_eq!(verdict.first().map(|(law, ..)| law.name), Some("unit-normals"));
    let mirrored = verdict.asked.iter().find(|(law, _)| law.name == "mirrored");
    assert_eq!(mirrored.map(|(_, asked)| asked.findings[0].follows), Some(Some(0)));
}

/// Law: what a log calls things stands on the page as text, and the page begins with the sentence. Oracle: names of markup.
#[test]
fn names_are_text_on_the_page() {
    let lines = [
        r#"{"ray": "<i>", "kind": "<b>", "origin": [0, 2, 0], "direction": [0, -1, 0], "t": 2, "point": [1, 0, 0], "object": "<script>\u001b[31m"}"#,
        r#"{"ray": 2, "parent": "<i>", "kind": "shadow", "light": "<u>", "origin": [0, 0, 0], "direction": [0, 1, 0]}"#,
    ];
    let traced = traced(&lines.map(str::to_owned));
    let verdict = RayVerdict::of(traced);
    let page = verdict.page("<s>.jsonl");
    for tag in ["<i>", "<b>", "<script>", "<u>", "<s>", "\u{1b}"] {
        assert!(!page.contains(tag), "{tag}");
        assert!(tag.starts_with('<') || !verdict.text().contains(tag), "{tag}");
    }
    assert!(page.contains("from the point at its t"), "{page}");
}

/// Law: few printed digits make no short way an acne. Oracle: a room of one object, far from the origin and small.
#[test]
fn few_digits_are_no_acne() {
    let lines = [
        r#"{"ray": 0, "kind": "camera", "origin": [0, 0, 90], "direction": [0, 0, 1], "t": 10, "point": [0, 0, 100], "normal": [0, 0, -1], "object": "room"}"#,
        r#"{"ray": 1, "parent": 0, "kind": "diffuse", "origin": [0, 0, 100], "direction": [0, 0, -1], "t": 1, "point": [0, 0, 99], "object": "room"}"#,
    ];
    let traced = traced(&lines.map(str::to_owned));
    let verdict = RayVerdict::of(traced);
    assert!(!verdict.is_broken(), "{}", verdict.text());
}

/// Law: each pixel has its own verdict, and the worst is named. Oracle: two pixels, of which one has two broken rays.
#[test]
fn each_pixel_is_judged() {
    let line = |pixel: u32, ray: u32, point: f64| {
        format!(
            "{{\"pixel\": [{pixel}, 0], \"ray\": {ray}, \"kind\": \"camera\", \"origin\": [0, 0, 0], \"direction\": [0, 0, 1], \"t\": 1, \"point\": [{point}, 0, 1]}}"
        )
    };
    let traced = traced(&[line(0, 0, 0.0), line(1, 0, 1.0), line(1, 1, 2.0), line(2, 0, 0.0)]);
    let verdict = RayVerdict::of(traced);
    let found: Vec<_> = verdict.pixels().iter().map(|it| (it.rays, it.findings)).collect();
    assert_eq!(found, [(1, 0), (2, 2), (1, 0)]);
    let text = verdict.pixels_text();
    assert!(
        text.lines()
            .last()
            .is_some_and(|line| line.starts_with("worst: pixel (1, 0): 2 rays, 2 findings")),
        "{text}"
    );
}

/// Law: a direction that has drifted from length 1, as directions that are never normalised do, moves the hit of a program that
/// takes it for a unit vector, and that is no finding; a hit by the other root is one, and no other is called so. Oracle: the
/// roots with 60 digits.
#[test]
fn a_direction_that_drifted_is_no_finding() {
    let hit = |t: &str| {
        let lines = [
            r#"{"object": "high", "sphere": {"center": [-3.0, 6.5, 1.0], "radius": 0.9}}"#
                .to_owned(),
            format!(
                r#"{{"origin": [0.11302324568479842, 0.6138120790878434, 1.4130920954332635], "direction": [-0.4343672633396999, 0.9004726422895957, -0.02177386108860635], "t": {t}, "object": "high"}}"#
            ),
        ];
        RayVerdict::of(super::laws::traced(&lines))
    };
    assert!(!hit("5.838519953977411").is_broken(), "{}", hit("5.838519953977411").text());
    assert!(hit("5.839").is_broken());
    let far = hit("7.5").sentence();
    assert!(far.contains("the farther root is taken"), "{far}");
}
