// left.mjs -- small Phong ray tracer, left-handed: x right, y up, z into the picture.
//   node left.mjs > left.ppm
import fs from 'node:fs';

const WIDTH = 160, HEIGHT = 120;
const OFFSET = 1e-4;
const MAX_BOUNCES = 4;

// ------------------------------------------------------------------ maths
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const mul = (a, b) => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];
const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const negate = a => [-a[0], -a[1], -a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = a => Math.sqrt(dot(a, a));
const normalize = a => scale(a, 1 / length(a));
const reflect = (d, n) => sub(d, scale(n, 2 * dot(d, n)));

// 3x4 matrices, row major; points have w = 1, directions w = 0
const xform = (m, v, w) => [
  m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + m[3] * w,
  m[4] * v[0] + m[5] * v[1] + m[6] * v[2] + m[7] * w,
  m[8] * v[0] + m[9] * v[1] + m[10] * v[2] + m[11] * w,
];
// multiply by the transposed 3x3 part
const xformT = (m, v) => [
  m[0] * v[0] + m[4] * v[1] + m[8] * v[2],
  m[1] * v[0] + m[5] * v[1] + m[9] * v[2],
  m[2] * v[0] + m[6] * v[1] + m[10] * v[2],
];
function trs(t, angleY, s) {
  const c = Math.cos(angleY), n = Math.sin(angleY);
  return [
    c * s[0], 0, n * s[2], t[0],
    0, s[1], 0, t[1],
    -n * s[0], 0, c * s[2], t[2],
  ];
}
function inverse(m) {
  const a = [m[0], m[4], m[8]], b = [m[1], m[5], m[9]], c = [m[2], m[6], m[10]];
  const det = dot(a, cross(b, c));
  const r0 = scale(cross(b, c), 1 / det), r1 = scale(cross(c, a), 1 / det), r2 = scale(cross(a, b), 1 / det);
  const t = [m[3], m[7], m[11]];
  return [...r0, -dot(r0, t), ...r1, -dot(r1, t), ...r2, -dot(r2, t)];
}

// ------------------------------------------------------------------ shapes
class Sphere {
  constructor(name, center, radius, material) { Object.assign(this, { name, center, radius, material }); }
  intersect(o, d, hit) {
    const oc = sub(o, this.center);
    const a = dot(d, d), b = 2 * dot(oc, d), c = dot(oc, oc) - this.radius * this.radius;
    const disc = b * b - 4 * a * c;
    if (disc < 0) return false;
    const root = Math.sqrt(disc);
    let t = (-b - root) / (2 * a);
    if (t < 0) t = (-b + root) / (2 * a);
    if (t < 0 || t >= hit.t) return false;
    hit.t = t;
    hit.point = add(o, scale(d, t));
    hit.normal = scale(sub(hit.point, this.center), 1 / this.radius);
    hit.shading = hit.normal;
    hit.uv = null;
    hit.name = this.name;
    hit.material = this.material;
    return true;
  }
}

class Mesh {
  constructor(name, vertices, normals, faces, matrix, material) {
    Object.assign(this, { name, vertices, normals, faces, matrix, material });
    this.inv = inverse(matrix);
  }
  intersect(o, d, hit) {
    // into the mesh's own space; the direction keeps its length, so t stays the same
    const lo = xform(this.inv, o, 1), ld = xform(this.inv, d, 0);
    let found = false;
    for (let i = 0; i < this.faces.length; i++) {
      const [i0, i1, i2] = this.faces[i];
      const v0 = this.vertices[i0];
      const e1 = sub(this.vertices[i1], v0), e2 = sub(this.vertices[i2], v0);
      const p = cross(ld, e2);
      const det = dot(e1, p);
      if (Math.abs(det) < 1e-12) continue;
      const s = sub(lo, v0);
      const u = dot(s, p) / det;
      if (u < 0 || u > 1) continue;
      const q = cross(s, e1);
      const v = dot(ld, q) / det;
      if (v < 0 || u + v > 1) continue;
      const t = dot(e2, q) / det;
      if (t < 0 || t >= hit.t) continue;
      found = true;
      hit.t = t;
      hit.point = add(o, scale(d, t));
      hit.normal = normalize(xformT(this.inv, cross(e1, e2)));
      hit.shading = hit.normal;
      if (this.normals) {
        const n = add(add(scale(this.normals[i0], 1 - u - v), scale(this.normals[i1], u)), scale(this.normals[i2], v));
        hit.shading = normalize(xformT(this.inv, n));
      }
      hit.uv = [u, v];
      hit.name = `${this.name}.${i}`;
      hit.material = this.material;
    }
    return found;
  }
}

function icosahedron() {
  const g = (1 + Math.sqrt(5)) / 2;
  const v = [
    [-1, g, 0], [1, g, 0], [-1, -g, 0], [1, -g, 0],
    [0, -1, g], [0, 1, g], [0, -1, -g], [0, 1, -g],
    [g, 0, -1], [g, 0, 1], [-g, 0, -1], [-g, 0, 1],
  ].map(normalize);
  const f = [
    [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11],
    [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6], [7, 1, 8],
    [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9],
    [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1],
  ];
  return { v, f };
}

// ------------------------------------------------------------------ scene
const ico = icosahedron();
const objects = [
  new Mesh('ground',
    [[-6, 0, -6], [-6, 0, 10], [6, 0, 10], [6, 0, -6]], null, [[0, 1, 2], [0, 2, 3]],
    trs([0, 0, 0], 0, [1, 1, 1]), { color: [0.6, 0.65, 0.6], kd: 0.8, ks: 0, shine: 1, mirror: 0.1 }),
  new Mesh('egg', ico.v, ico.v, ico.f,
    trs([-0.9, 1.25, 0.6], 0.5, [0.7, 1.2, 0.9]), { color: [0.9, 0.55, 0.15], kd: 0.8, ks: 0.4, shine: 20.5, mirror: 0 }),
  new Mesh('pyramid', [[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1], [0, 1.5, 0]], null,
    [[0, 4, 3], [3, 4, 2], [2, 4, 1], [1, 4, 0], [0, 2, 1], [0, 3, 2]],
    trs([2.1, 0.001, 2.2], -0.4, [0.8, 1, 0.8]), { color: [0.5, 0.3, 0.7], kd: 0.9, ks: 0.1, shine: 10, mirror: 0 }),
  new Sphere('chrome', [0.85, 0.8, 0.1], 0.8, { color: [0.8, 0.8, 0.85], kd: 0.2, ks: 0.7, shine: 100, mirror: 0.7 }),
  new Sphere('ball', [-0.3, 0.35, -1.1], 0.35, { color: [0.8, 0.15, 0.2], kd: 0.8, ks: 0.5, shine: 40, mirror: 0.1 }),
  new Sphere('moon', [-2.6, 3.6, 1.5], 0.4, { color: [0.7, 0.7, 0.7], kd: 1, ks: 0, shine: 1, mirror: 0 }),
];
const lights = [
  { name: 'sun', directional: normalize([0.5, -1, 0.7]), color: [0.9, 0.85, 0.75] },   // the way it shines
  { name: 'lamp', point: [-2.0, 2.7, 0.4], color: [4, 4.5, 5.5] },
];
const AMBIENT = [0.12, 0.13, 0.15];
const SKY = [0.25, 0.35, 0.55];

// ------------------------------------------------------------------ log
const every = Number((process.env.RAYS ?? '/1').replace('/', '')) || 1;
const log = process.env.LOG ? [] : null;
let pixel = null, nextId = 0;
const arr = v => '[' + v.join(',') + ']';
function logRay(text) {
  if (pixel) log.push(`{"pixel":${arr(pixel)},${text}}`);
}
if (log) {
  log.push(`{"rays":1,"program":"left.mjs","precision":"double","size":[${WIDTH},${HEIGHT}]}`);
  for (const o of objects) {
    if (o instanceof Sphere) log.push(`{"object":"${o.name}","sphere":{"center":${arr(o.center)},"radius":${o.radius}}}`);
    else o.faces.forEach((f, i) => {
      const vs = f.map(k => arr(xform(o.matrix, o.vertices[k], 1)));
      const ns = o.normals ? `,"normals":${arr(f.map(k => arr(xformT(inverse(o.matrix), o.normals[k]))))}` : '';
      log.push(`{"object":"${o.name}.${i}","triangle":{"vertices":${arr(vs)}${ns}}}`);
    });
  }
  for (const l of lights) log.push(`{"lamp":"${l.name}",` + (l.point ? `"point":${arr(l.point)}}` : `"directional":${arr(l.directional)}}`));
}

// ------------------------------------------------------------------ tracing
function closest(o, d, tmax = Infinity) {
  const hit = { t: tmax };
  let any = false;
  for (const obj of objects) if (obj.intersect(o, d, hit)) any = true;
  return any ? hit : null;
}

function phong(hit, n, side, d, id) {
  let sum = [0, 0, 0];
  const m = hit.material;
  for (const light of lights) {
    const start = add(hit.point, scale(side, OFFSET));
    let toLight, tmax, arriving;
    if (light.point) {
      toLight = sub(light.point, start);      // t = 1 is the lamp
      tmax = 1;
      arriving = scale(light.color, 1 / dot(toLight, toLight));
    } else {
      toLight = negate(light.directional);
      tmax = Infinity;
      arriving = light.color;
    }
    const l = normalize(toLight);
    const cos = dot(n, l);
    if (cos <= 0 || dot(side, l) <= 0) continue;
    const blocker = closest(start, toLight, tmax);
    const r = reflect(negate(l), n);
    const spec = m.ks * Math.pow(Math.max(0, -dot(r, d)), m.shine);
    const weight = add(scale(m.color, m.kd * cos), [spec, spec, spec]);
    const seen = blocker ? [0, 0, 0] : arriving;
    sum = add(sum, mul(weight, seen));
    logRay(`"ray":${nextId++},"parent":${id},"kind":"shadow","origin":${arr(start)},"direction":${arr(toLight)},"light":"${light.name}",`
      + (blocker ? `"t":${blocker.t},"by":"${blocker.name}",` : '"t":null,')
      + `"cos":${cos},"weight":${arr(weight)},"radiance":${arr(seen)}`);
  }
  return sum;
}

function trace(o, d, depth, kind, parent, weight) {
  const id = nextId++;
  const head = `"ray":${id},` + (parent === null ? '' : `"parent":${parent},"weight":${weight},`)
    + `"kind":"${kind}","origin":${arr(o)},"direction":${arr(d)}`;
  const hit = closest(o, d);
  if (!hit) {
    logRay(`${head},"t":null,"radiance":${arr(SKY)}`);
    return SKY;
  }
  const m = hit.material;
  const back = dot(hit.normal, d) > 0;
  const side = back ? negate(hit.normal) : hit.normal;
  const n = back ? negate(hit.shading) : hit.shading;
  const ambient = mul(AMBIENT, m.color);
  let color = add(ambient, phong(hit, n, side, d, id));
  if (m.mirror > 0 && depth < MAX_BOUNCES) {
    const r = reflect(d, n);
    const start = add(hit.point, scale(side, OFFSET));
    const mirrored = trace(start, r, depth + 1, 'reflected', id, m.mirror);
    color = add(color, scale(mirrored, m.mirror));
  }
  logRay(`${head},"t":${hit.t},"point":${arr(hit.point)},"normal":${arr(hit.normal)},"shading_normal":${arr(hit.shading)},`
    + (hit.uv ? `"uv":${arr(hit.uv)},` : '') + `"object":"${hit.name}","direct":${arr(ambient)},"radiance":${arr(color)}`);
  return color;
}

// ------------------------------------------------------------------ camera
const eye = [0.4, 1.9, -5.2], target = [0.2, 0.9, 0.5], fov = 48;
const forward = normalize(sub(target, eye));
const right = normalize(cross([0, 1, 0], forward));     // left-handed
const up = cross(forward, right);
const tan = Math.tan(fov * Math.PI / 360);

const ppm = [`P3\n${WIDTH} ${HEIGHT}\n255`];
const byte = v => Math.round(255 * Math.pow(Math.min(1, Math.max(0, v)), 1 / 2.2));
for (let y = 0; y < HEIGHT; y++) {
  for (let x = 0; x < WIDTH; x++) {
    pixel = log && x % every === 0 && y % every === 0 ? [x, y] : null;
    nextId = 0;
    const sx = (2 * (x + 0.5) / WIDTH - 1) * tan * WIDTH / HEIGHT;
    const sy = (1 - 2 * (y + 0.5) / HEIGHT) * tan;
    const d = normalize(add(forward, add(scale(right, sx), scale(up, sy))));
    const c = trace(eye, d, 0, 'camera', null, null);
    ppm.push(c.map(byte).join(' '));
  }
}
process.stdout.write(ppm.join('\n') + '\n');
if (log) fs.writeFileSync(process.env.LOG, log.join('\n') + '\n');
