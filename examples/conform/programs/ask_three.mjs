#!/usr/bin/env node
/* three.js answers `groundtruth conform`: by its Ray, spheres, planes and triangles; by its Raycaster over meshes with
 * `side: DoubleSide`, boxes, rectangles, meshes and these under a matrix (positions of meshes are in single precision,
 * as three.js stores them), all hits and parts of a ray; its two cameras; matrices.
 *
 * Needs: npm install three
 * Run: groundtruth conform -- node examples/conform/programs/ask_three.mjs
 * (The folder node_modules has to be beside this file, or above it.) */
import { createInterface } from "node:readline";
import * as THREE from "three";

class Unsupported extends Error {}

const vector = (list) => new THREE.Vector3(...list);

function step(data) {
  const [kind, x] = Object.entries(data)[0];
  const matrix = new THREE.Matrix4();
  switch (kind) {
    case "matrix": return matrix.set(...x.flat());
    case "translate": return matrix.makeTranslation(...x);
    case "scale": return matrix.makeScale(...x);
    case "reflect": return matrix.makeScale(...["x", "y", "z"].map((axis) => (axis === x ? -1 : 1)));
    case "shear": return matrix.makeShear(x[2], x[4], x[0], x[5], x[1], x[3]);
    case "rotate_x": return matrix.makeRotationX(THREE.MathUtils.degToRad(x));
    case "rotate_y": return matrix.makeRotationY(THREE.MathUtils.degToRad(x));
    case "rotate_z": return matrix.makeRotationZ(THREE.MathUtils.degToRad(x));
    case "rotate_about": {
      const [p, axis] = [vector(x.point), vector(x.direction).normalize()];
      matrix.makeRotationAxis(axis, THREE.MathUtils.degToRad(x.degrees));
      const back = new THREE.Matrix4().makeTranslation(p.clone().negate());
      return new THREE.Matrix4().makeTranslation(p).multiply(matrix).multiply(back);
    }
    default: throw new Unsupported(kind);
  }
}

/** Of a list of steps, the first applied first. */
function steps(list) {
  return list.reduce((matrix, data) => step(data).multiply(matrix), new THREE.Matrix4());
}

/** The hit of a Ray, whose direction has to be unit: point and normal; null for none, undefined for other shapes. */
function ofRay(shape, ray) {
  const [kind, data] = Object.entries(shape)[0];
  const point = new THREE.Vector3();
  if (kind === "sphere") {
    const center = vector(data.center);
    const found = ray.intersectSphere(new THREE.Sphere(center, data.radius), point);
    return found && [point, point.clone().sub(center).normalize()];
  }
  if (kind === "plane") {
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(vector(data.normal).normalize(), vector(data.point));
    return ray.intersectPlane(plane, point) && [point, plane.normal];
  }
  if (kind === "triangle") {
    const [a, b, c] = data.vertices.map(vector);
    const found = ray.intersectTriangle(a, b, c, false, point);
    return found && [point, THREE.Triangle.getNormal(a, b, c, new THREE.Vector3())];
  }
  return undefined;
}

function mesh(shape) {
  const [kind, data] = Object.entries(shape)[0];
  if (kind === "instance") {
    const inner = mesh(data.of);
    inner.matrix.premultiply(steps(data.transform));
    inner.updateMatrixWorld(true);
    return inner;
  }
  let geometry = new THREE.BufferGeometry();
  const fill = (points, faces) => {
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points.flat(), 3));
    geometry.setIndex(faces.flat());
  };
  if (kind === "box") {
    const [min, max] = [vector(data.min), vector(data.max)];
    const [size, middle] = [max.clone().sub(min), max.clone().add(min).multiplyScalar(0.5)];
    geometry = new THREE.BoxGeometry(size.x, size.y, size.z).translate(middle.x, middle.y, middle.z);
  } else if (kind === "rectangle") {
    const [p, a, b] = [data.corner, data.a, data.b];
    const corner = (i, j) => p.map((x, k) => x + i * a[k] + j * b[k]);
    fill([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)], [[0, 1, 2], [0, 2, 3]]);
  } else if (kind === "triangle") fill(data.vertices, [[0, 1, 2]]);
  else if (kind === "mesh" && data.vertices) fill(data.vertices, data.triangles);
  else throw new Unsupported(kind);
  const made = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
  made.matrixAutoUpdate = false;
  return made;
}

/** What is hit ahead and within the span, ascending. */
function hits(q, o, d, [low, high], all) {
  if (!q.shape) throw new Unsupported("a scene, or a list of shapes");
  if (low < 0) throw new Unsupported("hits behind the origin");
  const shape = q.transform ? { instance: { of: q.shape, transform: q.transform } } : q.shape;
  const [origin, length] = [vector(o), vector(d).length()];
  const ray = new THREE.Ray(origin, vector(d).normalize());
  if (!all && low === 0) {
    const found = ofRay(shape, ray);
    if (found === null) return [];
    if (found) return [{ t: found[0].distanceTo(origin) / length, normal: found[1].toArray() }];
  }
  const caster = new THREE.Raycaster(ray.origin, ray.direction, low * length, high * length);
  const target = mesh(shape);
  const toWorld = new THREE.Matrix3().getNormalMatrix(target.matrixWorld);
  const normal = (face) => face.normal.clone().applyNormalMatrix(toWorld).toArray();
  return caster.intersectObject(target).map((hit) => ({ t: hit.distance / length, normal: normal(hit.face) }));
}

function intersect(q) {
  const span = (q.span ?? [0, "inf"]).map((end) => Number(`${end}`.replace("inf", "Infinity")));
  const found = hits(q, q.ray.origin, q.ray.direction, span, q.all);
  return q.all ? found : found[0] ?? null;
}

function occluded(q) {
  if (!q.segment) throw new Unsupported("occluded along a ray");
  const { from, to } = q.segment;
  return hits(q, from, to.map((x, i) => x - from[i]), [0, 1]).some((hit) => hit.t < 1);
}

function camera(q) {
  const { camera: asked, image } = q;
  const [kind, lens] = Object.entries(asked.lens)[0];
  const [w, h] = [image.width, image.height].map((x) => x * (image.pixel_size ?? 1));
  let made;
  if (asked.stereo) throw new Unsupported("stereo");
  else if (kind === "pinhole") {
    made = new THREE.PerspectiveCamera(THREE.MathUtils.radToDeg(2 * Math.atan(h / (2 * lens.distance))), w / h);
  } else if (kind === "orthographic") made = new THREE.OrthographicCamera(-w / 2, w / 2, h / 2, -h / 2);
  else throw new Unsupported(kind);
  made.zoom = lens.zoom ?? 1;
  made.position.set(...asked.eye);
  made.up.set(...(asked.up ?? [0, 1, 0]));
  made.lookAt(...(asked.look_at ?? [0, 0, 0]));
  made.rotateZ(THREE.MathUtils.degToRad(asked.roll ?? 0));
  made.updateProjectionMatrix();
  made.updateMatrixWorld();
  return made;
}

function camera_ray(q) {
  const { width, height } = q.image;
  const [[column, row], place] = [q.pixel, q.place ?? [0.5, 0.5]];
  const at = new THREE.Vector2((2 * (column + place[0])) / width - 1, (2 * (height - 1 - row + place[1])) / height - 1);
  const caster = new THREE.Raycaster();
  caster.setFromCamera(at, camera(q));
  return { origin: caster.ray.origin.toArray(), direction: caster.ray.direction.toArray() };
}

function project(q) {
  const [made, point] = [camera(q), vector(q.point)];
  const view = new THREE.Matrix4().multiplyMatrices(made.projectionMatrix, made.matrixWorldInverse);
  if (!new THREE.Frustum().setFromProjectionMatrix(view).containsPoint(point)) return null;
  point.project(made);
  return { image: [((point.x + 1) * q.image.width) / 2, ((1 - point.y) * q.image.height) / 2] };
}

function transform(q) {
  const matrix = steps(q.steps);
  const rows = (m) => [0, 1, 2].map((i) => [0, 1, 2, 3].map((j) => m.elements[4 * j + i]));
  return { matrix: rows(matrix), inverse: rows(matrix.clone().invert()) };
}

const QUESTIONS = { intersect, occluded, camera_ray, project, transform };

// The protocol: a question is a line, and so is its answer, with the same id.

function reply(line) {
  const { id, ...question } = JSON.parse(line);
  const [name, data] = Object.entries(question)[0];
  if (!QUESTIONS[name]) return { id, unsupported: name };
  try {
    return { id, answer: QUESTIONS[name](data) };
  } catch (error) {
    return error instanceof Unsupported ? { id, unsupported: error.message } : { id, error: `${error}` };
  }
}

createInterface({ input: process.stdin }).on("line", (line) => {
  process.stdout.write(JSON.stringify(reply(line)) + "\n");
});
