//! The rays of a tree over the scene, seen from an orbiting camera, as SVG.

use std::collections::BTreeMap;
use std::fmt::Write;

use explain::RecordedRay;
use groundtruth::film::{Film, Tone, data_uri};
use groundtruth::math::Vector;
use groundtruth::rgb::Rgb;
use groundtruth::world::World;
use rayon::prelude::*;

use super::{
    Backdrop, End, Orbit, Role, Section, Segment, Sight, arrowhead, ink, of_hits, of_scene,
    segments,
};

/// Width and height of the picture, in its own units.
const SIZE: [f64; 2] = [800.0, 520.0];
/// Units of the picture for each pixel of the scene behind the lines.
const BLOCK: u32 = 2;
/// The least share of its sample of a ray whose hit is framed.
const FRAMED: f64 = 0.01;
/// How much of the scene's colours remains: lines and words must stand out, also on paper.
const REMAINS: f64 = 0.5;
/// The most pieces that are drawn.
const MAX_PIECES: usize = 1000;
/// With more pieces than this, their rays have no numbers.
const NUMBERED: usize = 24;
/// The parts of a piece that are tested for being hidden.
const PARTS: u32 = 48;
/// The height of the legend.
const LEGEND: f64 = 34.0;

/// A camera that sees what the rays of a tree meet that have at least 1 % of its light, or all if none hits anything: across the plane of incidence of the section that says most, a little
/// from above, from the side where less is hidden.
pub fn orbit_of(world: &World, root: &RecordedRay) -> Orbit {
    let shares: BTreeMap<usize, f64> = root.rays().iter().map(|it| (it.number, it.share)).collect();
    let mut pieces = segments(world, root, 1.0);
    if pieces.iter().any(|piece| piece.end == End::Hit && shares[&piece.ray] >= FRAMED) {
        pieces.retain(|piece| shares[&piece.ray] >= FRAMED);
    }
    let ball = of_hits(world, &pieces).unwrap_or_else(|| of_scene(world));
    let section = Section::first(root).and_then(|ray| Section::of(world, root, ray));
    let across = section.map_or(Vector::Z, |section| section.plane.normal());
    let sides = [across, -across].map(|side| Orbit::from_side(ball, side + ABOVE * Vector::Y));
    let backdrop = Backdrop { world, faded: &[] };
    let hidden = sides.map(|orbit| {
        let eye = orbit.sight(SIZE).eye;
        pieces.iter().take(SAMPLED).filter(|it| backdrop.hides(eye, it.middle()).is_some()).count()
    });
    if hidden[1] < hidden[0] { sides[1] } else { sides[0] }
}

/// The objects that hide much of a tree from this camera: each at least a fifth of its pieces, when those before it are
/// looked through. A room seen from outside is found so.
pub fn hiding(world: &World, root: &RecordedRay, orbit: &Orbit) -> Vec<u32> {
    let eye = orbit.sight(SIZE).eye;
    let pieces = segments(world, root, orbit.distance);
    let sampled = &pieces[..pieces.len().min(SAMPLED)];
    let mut faded = Vec::new();
    loop {
        let mut counts: BTreeMap<u32, usize> = BTreeMap::new();
        let backdrop = Backdrop { world, faded: &faded };
        for piece in sampled {
            if let Some(hit) = backdrop.hides(eye, piece.middle()) {
                *counts.entry(hit.object.index).or_default() += 1;
            }
        }
        let most = counts.into_iter().max_by_key(|&(_, count)| count);
        match most {
            Some((object, count)) if 5 * count >= sampled.len() => faded.push(object),
            _ => return faded,
        }
    }
}

/// The most pieces of a tree that are asked whether they are hidden.
const SAMPLED: usize = 64;

/// The tangent of the angle from which the camera looks down on an upright plane.
const ABOVE: f64 = 0.35;

/// What is drawn of a tree.
struct View<'a> {
    sight: Sight,
    backdrop: Backdrop<'a>,
    /// By their numbers.
    rays: BTreeMap<usize, &'a RecordedRay>,
}

/// The rays of a tree from this camera, over the scene (a PNG in it): hidden parts faint, arrowheads, numbers of the rays
/// if they are few, and a legend. At most a thousand pieces, those of the largest shares, are drawn. A ray that leaves the
/// scene goes on to the border.
pub fn svg_of_rays(world: &World, root: &RecordedRay, orbit: &Orbit, faded: &[u32]) -> String {
    let sight = orbit.sight(SIZE);
    let backdrop = Backdrop { world, faded };
    let rays: BTreeMap<usize, &RecordedRay> =
        root.rays().into_iter().map(|ray| (ray.number, ray)).collect();
    let mut pieces = segments(world, root, 8.0 * orbit.distance);
    let all = pieces.len();
    if all > MAX_PIECES {
        // stable: equal shares stay in the order of the tree
        pieces.sort_by(|a, b| rays[&b.ray].share.total_cmp(&rays[&a.ray].share));
        pieces.truncate(MAX_PIECES);
        pieces.sort_by_key(|piece| piece.ray);
    }
    let view = View { sight, backdrop, rays };
    let [width, height] = SIZE;
    let background = data_uri(&backdrop_film(&backdrop, &sight), &Tone::PLAIN);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {}\" role=\"img\" \
         font-family=\"system-ui, sans-serif\" font-size=\"18\">\n<title>The rays in space</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
         <image href=\"{background}\" width=\"{width}\" height=\"{height}\"/>\n\
         <svg width=\"{width}\" height=\"{height}\">\n",
        height + LEGEND
    );
    let is_numbered = pieces.len() <= NUMBERED;
    pieces.iter().for_each(|piece| view.write_piece(&mut svg, piece));
    let mut numbers = Vec::new();
    for piece in pieces.iter().filter(|_| is_numbered) {
        view.write_number(&mut svg, piece, &mut numbers);
    }
    svg += "</svg>\n";
    view.write_legend(&mut svg, &pieces, all);
    svg + "</svg>\n"
}

/// The scene behind the lines, paler than it is, with the contours of its objects.
fn backdrop_film(backdrop: &Backdrop<'_>, sight: &Sight) -> Film {
    let [columns, rows] = SIZE.map(|side| side as u32 / BLOCK);
    let block = f64::from(BLOCK);
    let pale = |color: Rgb| Rgb::WHITE - REMAINS * (Rgb::WHITE - Tone::SCREEN.map(color));
    let look = |index: u32| {
        let [x, y] = [index % columns, index / columns].map(|it| block * (f64::from(it) + 0.5));
        let ray = sight.ray([x, y]);
        let (color, object) = backdrop.seen(&ray, Rgb::WHITE);
        (object, pale(color))
    };
    let seen: Vec<(Option<u32>, Rgb)> = (0..columns * rows).into_par_iter().map(look).collect();
    let mut film = Film::new(columns, rows);
    for y in 0..rows {
        for x in 0..columns {
            let at = |x: u32, y: u32| seen[(y * columns + x) as usize];
            let (object, color) = at(x, y);
            let differs = |next: (Option<u32>, Rgb)| next.0 != object;
            let is_contour = x > 0 && differs(at(x - 1, y)) || y > 0 && differs(at(x, y - 1));
            film.set([x, y], if is_contour { 0.5 * color } else { color });
        }
    }
    film
}

impl View<'_> {
    fn role(&self, piece: &Segment) -> Role {
        Role::of(self.rays[&piece.ray].kind, piece.end)
    }

    fn write_piece(&self, svg: &mut String, piece: &Segment) {
        let Some([(start, first), (end, last)]) = self.sight.clip(piece.from, piece.to) else {
            return;
        };
        let role = self.role(piece);
        let ink = ink(role);
        let way = piece.to - piece.from;
        let [from, to] = [first, last].map(|part| piece.from + part * way);
        let dashes = if role == Role::Dark { " stroke-dasharray=\"3 6\"" } else { "" };
        let _ = writeln!(svg, "<g data-ray=\"{}\" stroke=\"{ink}\" fill=\"{ink}\">", piece.ray);
        for ([a, b], is_hidden) in self.backdrop.runs(self.sight.eye, from, to, PARTS) {
            let ends = [a, b].map(|part| self.sight.project(from + part * (to - from)));
            let [Some([x1, y1]), Some([x2, y2])] = ends else { continue };
            let opacity = if is_hidden { 0.25 } else { 1.0 };
            let _ = writeln!(
                svg,
                "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke-width=\"3\" \
                 stroke-linecap=\"round\" opacity=\"{opacity}\"{dashes}/>"
            );
        }
        if let Some(head) = arrowhead(&[start, end], 14.0).filter(|_| role != Role::Dark) {
            let corners = head.map(|[x, y]| format!("{x:.1},{y:.1}")).join(" ");
            let _ = writeln!(svg, "<polygon points=\"{corners}\" stroke=\"none\"/>");
        }
        if piece.end != End::Leaves && last == 1.0 {
            let [x, y] = end;
            let _ = writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" stroke=\"none\"/>");
        }
        svg.push_str("</g>\n");
    }

    /// The number of the ray beside what is seen of it, away from the numbers that are there already.
    fn write_number(&self, svg: &mut String, piece: &Segment, numbers: &mut Vec<[f64; 2]>) {
        if piece.end == End::Dark {
            return;
        }
        let Some([(start, _), (end, _)]) = self.sight.clip(piece.from, piece.to) else { return };
        let at = |part: f64| [0, 1].map(|axis| start[axis] + part * (end[axis] - start[axis]));
        let is_free = |[x, y]: &[f64; 2]| {
            numbers.iter().all(|[u, v]| (x - u).abs() > 24.0 || (y - v).abs() > 17.0)
        };
        let mut places = [0.65, 0.4, 0.8, 0.25, 0.52].map(at).into_iter();
        let [x, y] = places.find(is_free).unwrap_or(at(0.65));
        numbers.push([x, y]);
        let ink = ink(self.role(piece));
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" fill=\"{ink}\" stroke=\"#ffffff\" stroke-width=\"4\" \
             paint-order=\"stroke\">{}</text>",
            x + 7.0,
            y - 5.0,
            piece.ray
        );
    }

    /// The colours that occur, and how many pieces are left out.
    fn write_legend(&self, svg: &mut String, pieces: &[Segment], all: usize) {
        let y = SIZE[1] + 0.7 * LEGEND;
        let _ = write!(svg, "<text x=\"8\" y=\"{y:.1}\">");
        let roles: Vec<Role> = pieces.iter().map(|piece| self.role(piece)).collect();
        for (role, _, words) in Role::RAYS {
            if roles.contains(&role) {
                let _ = write!(svg, "<tspan fill=\"{}\">— {words}  </tspan>", ink(role));
            }
        }
        if all > pieces.len() {
            let _ = write!(svg, "<tspan>({} more not drawn)</tspan>", all - pieces.len());
        }
        svg.push_str("</text>\n");
    }
}
