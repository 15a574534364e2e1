/* A small Whitted tracer in double precision that writes down its rays: a floor that is a plane, a mirror and a glass
   ball, two lamps, every reflected and refracted ray followed. Rays start a little off the surface, along the normal.
       cc -O2 -std=c99 -I. tracer.c -o tracer -lm && RAYS=/8 ./tracer > picture.ppm && groundtruth rays rays.jsonl */
#include <math.h>
#define RAYS_IMPLEMENTATION
#include "rays_c.h"

typedef struct { double x, y, z; } vec;
static vec v(double x, double y, double z) { vec a = {x, y, z}; return a; }
static vec add(vec a, vec b) { return v(a.x + b.x, a.y + b.y, a.z + b.z); }
static vec sub(vec a, vec b) { return v(a.x - b.x, a.y - b.y, a.z - b.z); }
static vec mul(vec a, vec b) { return v(a.x * b.x, a.y * b.y, a.z * b.z); }
static vec scale(double s, vec a) { return v(s * a.x, s * a.y, s * a.z); }
static double dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec unit(vec a) { return scale(1 / sqrt(dot(a, a)), a); }

#define OFFSET 1e-6
#define SPHERE "{\"object\": \"%s\", \"sphere\": {\"center\": [%.17g, %.17g, %.17g], \"radius\": %.17g}}"

/* kd, ks, kr, kt as in Whitted's paper: diffuse, highlight, mirrored and refracted light */
typedef struct { const char *name; vec center; double radius; vec color; double kd, ks, kr, kt; } ball;
static const ball balls[] = {
    {"plane", {0, 0, 0}, 0, {0.9, 0.8, 0.6}, 0.9, 0, 0.1, 0}, /* y = 0 */
    {"chrome", {-1.3, 1.2, -1}, 1.2, {0.3, 0.3, 0.4}, 0.2, 0.5, 0.7, 0},
    {"glass", {0.9, 0.8, 0.8}, 0.8, {1, 1, 1}, 0.02, 0.3, 0.1, 0.85},
    {"plum", {2.4, 0.6, -1.2}, 0.6, {0.6, 0.2, 0.5}, 0.8, 0.4, 0.1, 0},
};
enum { BALLS = sizeof balls / sizeof *balls };
static const struct { const char *name; vec place, power; } lamps[] = {
    {"key", {5, 8, 6}, {90, 85, 75}},
    {"fill", {-6, 5, 4}, {15, 18, 25}},
};

typedef struct { double t; vec point, normal; const ball *what; } hit;

/* the nearest hit of a unit direction before `far` */
static int nearest(vec o, vec d, double far, hit *found) {
    *found = (hit){far, o, d, NULL};
    for (int i = 0; i < BALLS; ++i) {
        double t = -o.y / d.y;
        if (balls[i].radius > 0) {
            vec between = sub(o, balls[i].center);
            double half = dot(between, d), square = half * half - dot(between, between) + balls[i].radius * balls[i].radius;
            if (square < 0) continue;
            t = -half - sqrt(square);
            if (t <= 0) t = -half + sqrt(square);
        }
        if (t > 0 && t < found->t) *found = (hit){t, add(o, scale(t, d)), v(0, 1, 0), &balls[i]};
    }
    if (!found->what) return 0;
    if (found->what->radius > 0) found->normal = unit(sub(found->point, found->what->center));
    return 1;
}

static vec color_at(const hit *at) {
    int odd = at->what->radius == 0 && ((int)floor(at->point.x) + (int)floor(at->point.z)) % 2 != 0;
    return scale(odd ? 0.3 : 1, at->what->color);
}

/* Phong's model, n to the viewer's side */
static vec direct(const hit *at, vec n, vec d) {
    vec sum = scale(0.03, color_at(at));
    for (int i = 0; i < 2; ++i) {
        vec start = add(at->point, scale(OFFSET, n)), way = sub(lamps[i].place, start);
        double length = sqrt(dot(way, way)), cosine = dot(way, n) / length;
        if (cosine <= 0) continue;
        vec to = scale(1 / length, way), mirrored = sub(scale(2 * cosine, n), to);
        hit blocker;
        rays_log log = rays_begin("shadow", start, to);
        rays_text(&log, "light", lamps[i].name);
        rays_number(&log, "end", length);
        if (nearest(start, to, length, &blocker)) {
            rays_hit(&log, blocker.t, blocker.point, blocker.normal, blocker.what->name);
            rays_end(&log);
            continue;
        }
        rays_end(&log);
        double gloss = at->what->ks * pow(fmax(0, -dot(mirrored, d)), 60);
        vec reflected = add(scale(at->what->kd * cosine, color_at(at)), v(gloss, gloss, gloss));
        sum = add(sum, scale(1 / (length * length), mul(lamps[i].power, reflected)));
    }
    return sum;
}

static vec trace(const char *kind, vec o, vec d, double weight, double eta, int depth) {
    hit at;
    rays_log log = rays_begin(kind, o, d);
    rays_color(&log, "weight", v(weight, weight, weight));
    if (eta > 0) rays_number(&log, "eta", eta);
    if (!nearest(o, d, HUGE_VAL, &at)) {
        vec sky = scale(0.5 + 0.5 * d.y, v(0.4, 0.55, 0.9));
        rays_color(&log, "emitted", sky);
        rays_color(&log, "radiance", sky);
        rays_end(&log);
        return sky;
    }
    rays_hit(&log, at.t, at.point, at.normal, at.what->name);
    int inside = dot(d, at.normal) > 0;
    vec n = inside ? scale(-1, at.normal) : at.normal;
    vec sum = inside ? v(0, 0, 0) : direct(&at, n, d);
    rays_color(&log, "direct", sum);
    double cosine = -dot(d, n), kr = at.what->kr, kt = at.what->kt;
    if (depth > 0 && kt > 0) {
        double index = inside ? 1 / 1.5 : 1.5, square = 1 - (1 - cosine * cosine) / (index * index);
        if (square > 0) {
            vec next = add(scale(1 / index, d), scale(cosine / index - sqrt(square), n));
            vec start = sub(at.point, scale(OFFSET, n));
            sum = add(sum, scale(kt, trace("transmitted", start, next, kt, index, depth - 1)));
        } else {
            kr += kt; /* total reflection */
        }
    }
    if (depth > 0 && kr > 0) {
        vec next = add(d, scale(2 * cosine, n)), start = add(at.point, scale(OFFSET, n));
        sum = add(sum, scale(kr, trace("reflected", start, next, kr, 0, depth - 1)));
    }
    rays_color(&log, "radiance", sum);
    rays_end(&log);
    return sum;
}

static int byte(double x) { return (int)(255.99 * sqrt(fmin(1, x))); }

int main(void) {
    const int width = 240, height = 160;
    char line[300];
    rays_line("{\"object\": \"plane\", \"plane\": {\"point\": [0, 0, 0], \"normal\": [0, 1, 0]}}");
    for (int i = 1; i < BALLS; ++i) {
        vec c = balls[i].center;
        snprintf(line, sizeof line, SPHERE, balls[i].name, c.x, c.y, c.z, balls[i].radius);
        rays_line(line);
    }
    for (int i = 0; i < 2; ++i) {
        vec p = lamps[i].place;
        snprintf(line, sizeof line, "{\"lamp\": \"%s\", \"point\": [%.17g, %.17g, %.17g]}", lamps[i].name, p.x, p.y, p.z);
        rays_line(line);
    }
    printf("P3\n%d %d\n255\n", width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            rays_pixel(x, y, 0);
            vec d = unit(v((x + 0.5 - width / 2) / height, (height / 2 - y - 0.5) / height - 0.12, -1.3));
            vec light = trace("camera", v(0, 1.8, 6), d, 1, 0, 5);
            printf("%d %d %d\n", byte(light.x), byte(light.y), byte(light.z));
        }
    return 0;
}
