// A small tracer that writes down its rays: a mesh whose corners have normals, lit by the sun. Shading and mirrored rays
// use the normal between those of the corners, `shading_normal`; the true one of the triangle decides on which side a ray
// starts. Matte ground, a gem that is a twisted and shiny octahedron.
//     javac Tracer.java Rays.java && RAYS=/8 java Tracer > picture.ppm && groundtruth rays rays.jsonl
public class Tracer {
    record Vec(double x, double y, double z) {
        Vec plus(Vec b) { return new Vec(x + b.x, y + b.y, z + b.z); }
        Vec minus(Vec b) { return new Vec(x - b.x, y - b.y, z - b.z); }
        Vec times(double s) { return new Vec(s * x, s * y, s * z); }
        Vec times(Vec b) { return new Vec(x * b.x, y * b.y, z * b.z); }
        double dot(Vec b) { return x * b.x + y * b.y + z * b.z; }
        Vec cross(Vec b) { return new Vec(y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x); }
        Vec unit() { return times(1 / Math.sqrt(dot(this))); }
        String list() { return "[" + x + ", " + y + ", " + z + "]"; }
    }

    static final double EPSILON = 1e-9;
    static final Vec BLACK = new Vec(0, 0, 0), WHITE = new Vec(1, 1, 1);
    static final Vec TO_SUN = new Vec(-1, 2, 1.5).unit(), SUN = new Vec(2.5, 2.3, 2);

    // a mesh: corners, their normals, and three corners for each triangle, counter-clockwise from outside
    record Mesh(String name, Vec[] corners, Vec[] normals, int[][] triangles, Vec color, double mirror) {
        void log() {
            StringBuilder points = new StringBuilder(), arrows = new StringBuilder();
            for (Vec corner : corners) points.append(points.length() == 0 ? "" : ", ").append(corner.list());
            for (Vec normal : normals) arrows.append(arrows.length() == 0 ? "" : ", ").append(normal.list());
            Rays.line("{\"object\": \"" + name + "\", \"mesh\": {\"vertices\": [" + points + "], \"normals\": [" + arrows
                + "], \"smooth\": true, \"triangles\": " + java.util.Arrays.deepToString(triangles) + "}}");
        }
    }
    record Hit(double t, Vec point, Vec normal, Vec shading, Mesh mesh) { }

    static final Mesh[] SCENE = { gem(), ground() };

    static Mesh gem() {
        Vec center = new Vec(0, 1.1, 0);
        Vec[] arms = { new Vec(1.2, 0, 0.3), new Vec(-1, 0.2, -0.2), new Vec(0, 1.3, 0), new Vec(0.1, -1, 0), new Vec(-0.3, 0, 1),
            new Vec(0.2, 0, -1.1) };
        Vec[] corners = new Vec[6], normals = new Vec[6];
        for (int i = 0; i < 6; i++) {
            corners[i] = center.plus(arms[i]);
            normals[i] = arms[i].unit();
        }
        int[][] triangles = { {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5} };
        return new Mesh("gem", corners, normals, triangles, new Vec(0.2, 0.5, 0.35), 0.4);
    }

    static Mesh ground() {
        Vec[] corners = { new Vec(-20, 0, -20), new Vec(-20, 0, 20), new Vec(20, 0, 20), new Vec(20, 0, -20) };
        Vec up = new Vec(0, 1, 0);
        return new Mesh("ground", corners, new Vec[] { up, up, up, up }, new int[][] { {0, 1, 2}, {0, 2, 3} }, new Vec(0.6, 0.55, 0.5), 0);
    }

    // Möller and Trumbore
    static Hit nearest(Vec o, Vec d) {
        Hit found = null;
        for (Mesh mesh : SCENE) {
            for (int[] corner : mesh.triangles) {
                Vec a = mesh.corners[corner[0]], ab = mesh.corners[corner[1]].minus(a), ac = mesh.corners[corner[2]].minus(a);
                Vec p = d.cross(ac), way = o.minus(a), q = way.cross(ab);
                double volume = ab.dot(p), v = way.dot(p) / volume, w = d.dot(q) / volume, t = ac.dot(q) / volume;
                if (!(v >= 0 && w >= 0 && v + w <= 1 && t > EPSILON) || found != null && t >= found.t) continue;
                Vec shading = mesh.normals[corner[0]].times(1 - v - w).plus(mesh.normals[corner[1]].times(v))
                    .plus(mesh.normals[corner[2]].times(w)).unit();
                found = new Hit(t, o.plus(d.times(t)), ab.cross(ac).unit(), shading, mesh);
            }
        }
        return found;
    }

    static Vec direct(Hit hit) {
        double cosine = TO_SUN.dot(hit.shading);
        if (cosine <= 0) return BLACK;
        Vec start = hit.point.plus(hit.normal.times(TO_SUN.dot(hit.normal) > 0 ? 1e-7 : -1e-7));
        try (Rays.Ray log = Rays.ray("shadow", start, TO_SUN)) {
            log.text("light", "sun");
            Hit blocker = nearest(start, TO_SUN);
            if (blocker == null) return hit.mesh.color.times(SUN).times(cosine / Math.PI);
            log.hit(blocker.t, blocker.point, blocker.normal, blocker.mesh.name);
            return BLACK;
        }
    }

    static Vec radiance(String kind, Vec o, Vec d, Vec weight, int depth) {
        try (Rays.Ray log = Rays.ray(kind, o, d)) {
            log.color("weight", weight);
            Hit hit = nearest(o, d);
            if (hit == null) {
                Vec sky = new Vec(0.45, 0.6, 0.85).times(0.6 + 0.4 * d.y);
                log.color("emitted", sky);
                log.color("radiance", sky);
                return sky;
            }
            log.hit(hit.t, hit.point, hit.normal, hit.mesh.name);
            log.color("shading_normal", hit.shading);
            Vec ambient = hit.mesh.color.times(0.15), direct = direct(hit).plus(ambient);
            log.color("direct", direct);
            Vec sum = direct, mirrored = d.minus(hit.shading.times(2 * d.dot(hit.shading)));
            // mirrored about the shading normal a ray may lead below the triangle: such light is left out
            if (depth > 0 && hit.mesh.mirror > 0 && mirrored.dot(hit.normal) * d.dot(hit.normal) < 0) {
                Vec share = WHITE.times(hit.mesh.mirror), start = hit.point.plus(hit.normal.times(d.dot(hit.normal) > 0 ? -1e-7 : 1e-7));
                sum = sum.plus(share.times(radiance("reflected", start, mirrored, share, depth - 1)));
            }
            log.color("radiance", sum);
            return sum;
        }
    }

    static int toByte(double x) { return (int) (255.99 * Math.sqrt(Math.min(1, x))); }

    public static void main(String[] arguments) {
        final int width = 200, height = 150;
        for (Mesh mesh : SCENE) mesh.log();
        Rays.line("{\"lamp\": \"sun\", \"directional\": " + TO_SUN.list() + "}");
        StringBuilder picture = new StringBuilder("P3\n" + width + " " + height + "\n255\n");
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                Rays.pixel(x, y, 0);
                Vec d = new Vec((x + 0.5) / height - 0.5 * width / height, 0.5 - (y + 0.5) / height - 0.2, -1.2).unit();
                Vec light = radiance("camera", new Vec(0.3, 2, 4.5), d, WHITE, 3);
                picture.append(toByte(light.x)).append(' ').append(toByte(light.y)).append(' ').append(toByte(light.z)).append('\n');
            }
        }
        System.out.print(picture);
    }
}
