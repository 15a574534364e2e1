// A small path tracer that writes down its rays, left-handed: x right, y up, z away from the viewer. Directions have any
// length, t is a length, normals face the viewer, and rays start a little along their own direction. Balls and a wall are
// lit by a lamp and the sky; glass and lacquer draw lots between their two ways.
//     RAYS=/8 node tracer.mjs > picture.ppm && groundtruth rays rays.jsonl
import "./rays.js";

const { rays } = globalThis;
const add = (a, b) => ({ x: a.x + b.x, y: a.y + b.y, z: a.z + b.z });
const times = (a, b) => ({ x: a.x * b.x, y: a.y * b.y, z: a.z * b.z });
const scale = (s, a) => ({ x: s * a.x, y: s * a.y, z: s * a.z });
const sub = (a, b) => add(a, scale(-1, b));
const dot = (a, b) => a.x * b.x + a.y * b.y + a.z * b.z;
const length = (a) => Math.sqrt(dot(a, a));
const unit = (a) => scale(1 / length(a), a);
const rgb = (x, y, z) => ({ x, y, z });
const black = rgb(0, 0, 0), white = rgb(1, 1, 1);

const epsilon = 1e-5;
const lamp = { x: -3, y: 5, z: -2 }, power = rgb(30, 28, 24);
const things = [
    { name: "wall", point: { x: 0, y: 0, z: 4 }, normal: { x: 0.3, y: 0, z: -1 }, color: rgb(0.7, 0.65, 0.6) },
    { name: "table", point: { x: 0, y: 0, z: 0 }, normal: { x: 0, y: 1, z: 0 }, color: rgb(0.5, 0.35, 0.25) },
    { name: "marble", center: { x: -0.8, y: 0.7, z: 0.2 }, radius: 0.7, index: 1.52, color: white },
    { name: "apple", center: { x: 0.9, y: 0.8, z: 0.9 }, radius: 0.8, lacquer: 0.2, color: rgb(0.7, 0.1, 0.05) },
    { name: "chrome", center: { x: 0.5, y: 0.35, z: -0.8 }, radius: 0.35, mirror: rgb(0.9, 0.9, 0.9) },
];

// the length to a thing, or Infinity
function meet(thing, o, d) {
    const u = unit(d);
    if (thing.normal) {
        const t = dot(sub(thing.point, o), thing.normal) / dot(u, thing.normal);
        return t > 0 ? t : Infinity;
    }
    const between = sub(o, thing.center);
    const half = dot(between, u);
    const square = half * half - dot(between, between) + thing.radius ** 2;
    const roots = square < 0 ? [] : [-half - Math.sqrt(square), -half + Math.sqrt(square)];
    return roots.find((t) => t > 0) ?? Infinity;
}

function nearest(o, d) {
    const [t, thing] = things.map((it) => [meet(it, o, d), it]).reduce((a, b) => (b[0] < a[0] ? b : a));
    if (t === Infinity) return null;
    const point = add(o, scale(t, unit(d)));
    const outward = unit(thing.normal ?? sub(point, thing.center));
    const inside = dot(outward, d) > 0;
    return { t, thing, point, inside, normal: inside ? scale(-1, outward) : outward };
}

let seed = 1;
function random() {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
}

// the cosine's density: a point of the unit sphere around the tip of the normal; no unit vector
function scatter(normal) {
    const z = 1 - 2 * random(), phi = 2 * Math.PI * random(), r = Math.sqrt(1 - z * z);
    return add(normal, { x: r * Math.cos(phi), y: r * Math.sin(phi), z });
}

const leave = (point, d) => add(point, scale(epsilon, unit(d)));

function direct({ point, normal, thing }) {
    const way = sub(lamp, point);
    const distance = length(way);
    const cosine = dot(way, normal) / distance;
    if (cosine <= 0) return black;
    const start = leave(point, way);
    const log = rays.ray("shadow", start, way);
    log.text("light", "lamp");
    log.number("end", distance - epsilon);
    const blocker = nearest(start, way);
    const isBlocked = blocker && blocker.t < distance - epsilon;
    if (isBlocked) log.hit(blocker.t, blocker.point, blocker.normal, blocker.thing.name);
    log.end();
    return isBlocked ? black : scale(cosine / (Math.PI * distance * distance), times(thing.color, power));
}

const fresnel = (cosine, from, to) => {
    const behind = Math.sqrt(Math.max(0, 1 - (from / to) ** 2 * (1 - cosine * cosine)));
    const s = (from * cosine - to * behind) / (from * cosine + to * behind);
    const p = (from * behind - to * cosine) / (from * behind + to * cosine);
    return (s * s + p * p) / 2;
};

// the next ray of a path: its kind, direction, weight, and the probability of this way
function next({ thing, normal, inside }, d) {
    const mirrored = sub(d, scale(2 * dot(d, normal), normal));
    if (thing.mirror) return { kind: "reflected", d: mirrored, weight: thing.mirror };
    if (thing.index) {
        const [from, to] = inside ? [thing.index, 1] : [1, thing.index];
        const cosine = -dot(unit(d), normal);
        const choice = fresnel(cosine, from, to);
        if (random() < choice) return { kind: "reflected", d: mirrored, weight: white, choice };
        const across = scale(from / to, add(unit(d), scale(cosine, normal)));
        const behind = scale(-Math.sqrt(1 - dot(across, across)), normal);
        return { kind: "transmitted", d: add(across, behind), weight: white, choice: 1 - choice, eta: from / to };
    }
    const choice = thing.lacquer ?? 0;
    if (random() < choice) return { kind: "reflected", d: mirrored, weight: white, choice };
    const way = scatter(normal);
    const cos = dot(unit(way), normal), f = scale((1 - choice) / Math.PI, thing.color);
    // the lacquer's share of light is the probability of its ray: neither is in the weight
    return { kind: "diffuse", d: way, weight: thing.color, choice: 1 - choice, f, cos, pdf: cos / Math.PI };
}

function radiance(o, d, by, depth) {
    const log = rays.ray(by.kind, o, d);
    log.color("weight", by.weight);
    if (by.f) log.color("f", by.f);
    for (const field of ["cos", "pdf", "choice", "eta"]) if (by[field]) log.number(field, by[field]);
    const hit = nearest(o, d);
    let light = hit ? black : rgb(0.35, 0.45, 0.6);
    if (hit) {
        log.hit(hit.t, hit.point, hit.normal, hit.thing.name);
        light = hit.thing.mirror || hit.thing.index ? black : scale(1 - (hit.thing.lacquer ?? 0), direct(hit));
        const sent = next(hit, d), start = leave(hit.point, sent.d);
        log.color("direct", light);
        if (depth > 0) light = add(light, times(sent.weight, radiance(start, sent.d, sent, depth - 1)));
    } else log.color("emitted", light);
    log.color("radiance", light);
    log.end();
    return light;
}

const [width, height, samples] = [160, 120, 8];
for (const { name, center, radius, point, normal } of things) {
    const list = (v) => [v.x, v.y, v.z];
    const plane = () => ({ plane: { point: list(point), normal: list(normal) } });
    rays.line({ object: name, ...(center ? { sphere: { center: list(center), radius } } : plane()) });
}
rays.line({ lamp: "lamp", point: [lamp.x, lamp.y, lamp.z] });
const picture = [`P3 ${width} ${height} 255`];
for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
        seed = y * width + x;
        let sum = black;
        for (let sample = 0; sample < samples; sample++) {
            rays.pixel(x, y, sample);
            const d = { x: x + random() - width / 2, y: height / 2 - y - random() - 20, z: 140 };
            sum = add(sum, radiance({ x: 0, y: 1.7, z: -5 }, d, { kind: "camera", weight: white }, 6));
        }
        picture.push([sum.x, sum.y, sum.z].map((c) => Math.floor(255.99 * Math.sqrt(Math.min(1, c / samples)))).join(" "));
    }
}
console.log(picture.join("\n"));
