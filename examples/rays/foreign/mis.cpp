// Iterative path tracer with next event estimation and multiple importance sampling.
// g++ -O2 -std=c++17 mis.cpp -o mis && ./mis > mis.ppm
#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

constexpr double PI = 3.14159265358979323846;
constexpr double INF = 1e300;
constexpr double TMIN = 1e-7;

struct V { double x, y, z; };
static V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static V operator-(V a) { return {-a.x, -a.y, -a.z}; }
static V operator*(V a, V b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
static V operator*(V a, double s) { return {a.x * s, a.y * s, a.z * s}; }
static V operator/(V a, double s) { return {a.x / s, a.y / s, a.z / s}; }
static double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static double len(V a) { return std::sqrt(dot(a, a)); }
static V unit(V a) { return a / len(a); }
static double maxc(V a) { return std::max(a.x, std::max(a.y, a.z)); }
static bool black(V a) { return a.x == 0 && a.y == 0 && a.z == 0; }

// pcg32
struct Rng {
    uint64_t s, inc;
    explicit Rng(uint64_t seed, uint64_t seq) : s(0), inc((seq << 1) | 1) { next(); s += seed; next(); }
    uint32_t next() {
        uint64_t o = s;
        s = o * 6364136223846793005ULL + inc;
        uint32_t x = (uint32_t)(((o >> 18) ^ o) >> 27), r = (uint32_t)(o >> 59);
        return (x >> r) | (x << ((32 - r) & 31));
    }
    double uni() { return (next() + 0.5) / 4294967296.0; }
};

enum Type { DIFFUSE, GLOSSY, GLASS };
struct Mat {
    Type type;
    V kd, ks;
    double exponent, ior;
    V Le;
};

enum Shape { QUAD, SPHERE };
struct Obj {
    const char* name;
    Shape shape;
    V c;          // corner or centre
    V a, b;       // sides
    double r;
    Mat m;
    double area() const { return shape == QUAD ? len(cross(a, b)) : 4 * PI * r * r; }
};

static const V O = {0, 0, 0};
static Mat diffuse(V kd) { return {DIFFUSE, kd, O, 0, 1, O}; }
static Mat emitter(V Le) { return {DIFFUSE, O, O, 0, 1, Le}; }
static Obj quad(const char* n, V c, V a, V b, Mat m) { return {n, QUAD, c, a, b, 0, m}; }
static Obj ball(const char* n, V c, double r, Mat m) { return {n, SPHERE, c, O, O, r, m}; }

static std::vector<Obj> scene = {
    quad("floor", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, diffuse({.7, .7, .7})),
    quad("ceiling", {-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, diffuse({.7, .7, .7})),
    quad("back", {-1, 0, -1}, {2, 0, 0}, {0, 2, 0}, diffuse({.7, .7, .7})),
    quad("left", {-1, 0, -1}, {0, 2, 0}, {0, 0, 2}, diffuse({.65, .08, .06})),
    quad("right", {1, 0, -1}, {0, 0, 2}, {0, 2, 0}, diffuse({.12, .45, .10})),
    quad("panel", {-.3, 1.98, -.3}, {.6, 0, 0}, {0, 0, .6}, emitter({14, 13, 11})),
    ball("bulb", {.62, 1.25, -.55}, .08, emitter({22, 16, 9})),
    ball("plastic", {-.42, .4, -.35}, .4, {GLOSSY, {.25, .3, .6}, {.35, .35, .35}, 60, 1, O}),
    ball("glass", {.45, .33, .25}, .33, {GLASS, O, {1, 1, 1}, 0, 1.5, O}),
};
static std::vector<int> lights;

struct Hit { double t; int obj; V p, n; };    // n: geometric, outward (quad: a x b)

static double hit_obj(const Obj& o, V ro, V rd, double tmax) {
    if (o.shape == QUAD) {
        V n = cross(o.a, o.b);
        double den = dot(rd, n);
        if (den == 0) return -1;
        double t = dot(o.c - ro, n) / den;
        if (t < TMIN || t >= tmax) return -1;
        V q = ro + rd * t - o.c;
        double u = dot(q, o.a) / dot(o.a, o.a), v = dot(q, o.b) / dot(o.b, o.b);
        if (u < 0 || u > 1 || v < 0 || v > 1) return -1;
        return t;
    }
    V oc = o.c - ro;
    double h = dot(oc, rd);
    V perp = oc - rd * h;
    double d2 = o.r * o.r - dot(perp, perp);
    if (d2 < 0) return -1;
    double s = std::sqrt(d2);
    double t = h - s;
    if (t < TMIN) t = h + s;
    if (t < TMIN || t >= tmax) return -1;
    return t;
}

static bool intersect(V ro, V rd, double tmax, Hit& h) {
    h.t = tmax;
    h.obj = -1;
    for (size_t i = 0; i < scene.size(); i++) {
        double t = hit_obj(scene[i], ro, rd, h.t);
        if (t > 0) { h.t = t; h.obj = (int)i; }
    }
    if (h.obj < 0) return false;
    const Obj& o = scene[h.obj];
    h.p = ro + rd * h.t;
    h.n = o.shape == QUAD ? unit(cross(o.a, o.b)) : (h.p - o.c) / o.r;
    return true;
}

// ---- sampling
static void basis(V n, V& t, V& b) {
    t = std::fabs(n.x) > .9 ? unit(cross(n, {0, 1, 0})) : unit(cross(n, {1, 0, 0}));
    b = cross(n, t);
}
static V cosine_dir(V n, double u1, double u2) {
    double r = std::sqrt(u1), phi = 2 * PI * u2;
    V t, b;
    basis(n, t, b);
    return unit(t * (r * std::cos(phi)) + b * (r * std::sin(phi)) + n * std::sqrt(1 - u1));
}
static V reflect(V d, V n) { return d - n * (2 * dot(d, n)); }

static double p_diffuse(const Mat& m) { return m.type == DIFFUSE ? 1 : maxc(m.kd) / (maxc(m.kd) + maxc(m.ks)); }

// BRDF and the density of sample_brdf for a given direction; n faces the viewer
static V eval_brdf(const Mat& m, V in, V n, V out) {
    if (dot(n, out) <= 0) return O;
    V f = m.kd / PI;
    if (m.type == GLOSSY) {
        double c = std::max(0.0, dot(reflect(in, n), out));
        f = f + m.ks * ((m.exponent + 2) / (2 * PI) * std::pow(c, m.exponent));
    }
    return f;
}
static double pdf_brdf(const Mat& m, V in, V n, V out) {
    double pd = p_diffuse(m);
    double p = pd * std::max(0.0, dot(n, out)) / PI;
    if (m.type == GLOSSY) {
        double c = std::max(0.0, dot(reflect(in, n), out));
        p += (1 - pd) * (m.exponent + 1) / (2 * PI) * std::pow(c, m.exponent);
    }
    return p;
}
static V sample_brdf(const Mat& m, V in, V n, Rng& g) {
    double u = g.uni(), u1 = g.uni(), u2 = g.uni();
    if (u < p_diffuse(m)) return cosine_dir(n, u1, u2);
    V r = reflect(in, n), t, b;
    basis(r, t, b);
    double ct = std::pow(u1, 1 / (m.exponent + 1)), st = std::sqrt(std::max(0.0, 1 - ct * ct));
    return unit(t * (st * std::cos(2 * PI * u2)) + b * (st * std::sin(2 * PI * u2)) + r * ct);
}

// a point on a lamp; returns the density per solid angle as seen from p
static double sample_light(const Obj& l, V p, Rng& g, V& d, double& dist) {
    double u1 = g.uni(), u2 = g.uni();
    V q, nl;
    if (l.shape == QUAD) {
        q = l.c + l.a * u1 + l.b * u2;
        nl = unit(cross(l.a, l.b));
        V w = q - p;
        dist = len(w);
        d = w / dist;
        double cosl = -dot(d, nl);
        if (cosl <= 0) return 0;
        return dist * dist / (cosl * l.area());
    }
    // sphere: uniform in the cone it fills
    V oc = l.c - p;
    double D2 = dot(oc, oc), s2 = l.r * l.r / D2;
    double cmax = std::sqrt(std::max(0.0, 1 - s2));
    double ct = 1 - u1 * (1 - cmax), st = std::sqrt(std::max(0.0, 1 - ct * ct)), phi = 2 * PI * u2;
    V w = oc / std::sqrt(D2), t, b;
    basis(w, t, b);
    d = unit(t * (st * std::cos(phi)) + b * (st * std::sin(phi)) + w * ct);
    double h = dot(oc, d);
    dist = h - std::sqrt(std::max(0.0, l.r * l.r - (D2 - h * h)));
    return 1 / (2 * PI * (1 - cmax));
}
static double pdf_light(const Obj& l, V p, V d, double dist, V nl) {
    if (l.shape == QUAD) {
        double cosl = -dot(d, nl);
        return cosl <= 0 ? 0 : dist * dist / (cosl * l.area());
    }
    V oc = l.c - p;
    double cmax = std::sqrt(std::max(0.0, 1 - l.r * l.r / dot(oc, oc)));
    return 1 / (2 * PI * (1 - cmax));
}
static double power_heuristic(double a, double b) { return a * a / (a * a + b * b); }

static V emitted(const Obj& o, V d, V n) {
    return dot(d, n) < 0 ? o.m.Le : O;      // one side only
}

// ---- my log
static FILE* flog = nullptr;
static bool logging = false;
static int px, py, smp, ids;
static std::string* held = nullptr;     // the line of the camera ray waits for its radiance
static void out(const char* fmt, ...) {
    va_list a;
    va_start(a, fmt);
    if (held) {
        char buf[512];
        vsnprintf(buf, sizeof buf, fmt, a);
        *held += buf;
    } else
        vfprintf(flog, fmt, a);
    va_end(a);
}
static void out(const char* name, V v) { out(",\"%s\":[%.17g,%.17g,%.17g]", name, v.x, v.y, v.z); }
static void begin(int id, int parent, const char* kind, V o, V d) {
    out("{\"pixel\":[%d,%d],\"sample\":%d,\"ray\":%d", px, py, smp, id);
    if (parent) out(",\"parent\":%d", parent);
    out(",\"kind\":\"%s\"", kind);
    out("origin", o);
    out("direction", d);
}

// ---- the integrator
static V radiance(V ro, V rd, Rng& g) {
    V L = O, T = {1, 1, 1};
    bool specular = true;
    double last_pdf = 0;
    // of the ray under way, for the log
    const char* kind = "camera";
    int parent = 0;
    V f = O, w = {1, 1, 1};
    double cosi = 0, pdf = 0, choice = 1, eta = 0;
    std::string camera_line;

    for (int depth = 0; depth < 24; depth++) {
        int id = ++ids;
        Hit h;
        bool hit = intersect(ro, rd, INF, h);
        V Le = O;
        double mis = 1;
        V n = O;
        if (hit) {
            const Obj& o = scene[h.obj];
            n = dot(rd, h.n) < 0 ? h.n : -h.n;
            Le = emitted(o, rd, h.n);
            if (!black(Le)) {
                if (!specular) {
                    double pl = pdf_light(o, ro, rd, h.t, h.n) / lights.size();
                    mis = power_heuristic(last_pdf, pl);
                }
                L = L + T * Le * mis;
            }
        }
        if (logging) {
            if (!parent) held = &camera_line;
            begin(id, parent, kind, ro, rd);
            if (parent) {
                if (pdf > 0) { out("f", f); out(",\"cos\":%.17g,\"pdf\":%.17g", cosi, pdf); }
                if (choice != 1) out(",\"choice\":%.17g", choice);
                if (eta != 0) out(",\"eta\":%.17g", eta);
                out("weight", w);
            }
            out("throughput", T);
            if (hit) {
                out(",\"t\":%.17g", h.t);
                out("point", h.p);
                out("normal", n);
                out(",\"front\":%s,\"object\":\"%s\"", dot(rd, h.n) < 0 ? "true" : "false", scene[h.obj].name);
                if (!black(Le)) { out("emitted", Le); out(",\"mis\":%.17g", mis); }
            } else
                out(",\"t\":null");
            held = nullptr;
            if (parent) out("}\n");
        }
        if (!hit) break;
        const Mat& m = scene[h.obj].m;
        if (!black(m.Le)) break;

        V next;
        choice = 1;
        eta = 0;
        if (m.type == GLASS) {
            bool front = dot(rd, h.n) < 0;
            double e = front ? 1 / m.ior : m.ior;
            double ci = -dot(rd, n), k = 1 - e * e * (1 - ci * ci), R = 1;
            double ct = 0;
            if (k > 0) {
                ct = std::sqrt(k);
                double rs = (e * ci - ct) / (e * ci + ct), rp = (e * ct - ci) / (e * ct + ci);
                R = (rs * rs + rp * rp) / 2;
            }
            if (g.uni() < R) {
                next = reflect(rd, n);
                kind = "reflected";
                choice = R;
            } else {
                next = unit(rd * e + n * (e * ci - ct));
                kind = "transmitted";
                choice = 1 - R;
                eta = e;
            }
            w = m.ks;
            f = O;
            pdf = 0;
            specular = true;
        } else {
            // next event estimation: one lamp
            int k = std::min((int)(g.uni() * lights.size()), (int)lights.size() - 1);
            const Obj& lamp = scene[lights[k]];
            double pick = 1.0 / lights.size();
            V ld;
            double dist;
            double lpdf = sample_light(lamp, h.p, g, ld, dist);
            double lcos = dot(n, ld);
            if (lpdf > 0 && lcos > 0) {
                V lf = eval_brdf(m, rd, n, ld);
                double lmis = power_heuristic(lpdf * pick, pdf_brdf(m, rd, n, ld));
                V lw = lf * (lcos * lmis / (lpdf * pick));
                Hit sh;
                bool blocked = intersect(h.p, ld, dist * (1 - 1e-6), sh);
                if (!blocked) L = L + T * lw * lamp.m.Le;
                if (logging) {
                    begin(++ids, id, "shadow", h.p, ld);
                    out(",\"end\":%.17g,\"light\":\"%s\"", dist, lamp.name);
                    if (blocked) out(",\"t\":%.17g,\"by\":\"%s\"", sh.t, scene[sh.obj].name);
                    else out(",\"t\":null");
                    out("f", lf);
                    out(",\"cos\":%.17g,\"pdf\":%.17g,\"choice\":%.17g,\"mis\":%.17g", lcos, lpdf, pick, lmis);
                    out("weight", lw);
                    out("throughput", T * lw);
                    out("radiance", blocked ? O : lamp.m.Le);
                    out("}\n");
                }
            }
            next = sample_brdf(m, rd, n, g);
            cosi = dot(n, next);
            if (cosi <= 0) break;
            f = eval_brdf(m, rd, n, next);
            pdf = pdf_brdf(m, rd, n, next);
            if (pdf <= 0) break;
            w = f * (cosi / pdf);
            kind = m.type == GLOSSY ? "glossy" : "diffuse";
            specular = false;
            last_pdf = pdf;
        }
        T = T * w;
        if (depth >= 3) {       // Russian roulette
            double q = std::min(0.95, maxc(T));
            if (g.uni() >= q) break;
            T = T / q;
            w = w / q;
            choice *= q;
        }
        parent = id;
        ro = h.p;
        rd = next;
    }
    if (logging) {
        fputs(camera_line.c_str(), flog);
        out("radiance", L);
        out("}\n");
    }
    return L;
}

int main() {
    const int W = 160, H = 120, SPP = 32;
    for (size_t i = 0; i < scene.size(); i++)
        if (!black(scene[i].m.Le)) lights.push_back((int)i);

    int every = 1;
    if (const char* e = getenv("RAYS")) sscanf(e, "/%d", &every);
    if (const char* e = getenv("LOG")) {
        flog = fopen(e, "w");
        out("{\"rays\":1,\"program\":\"mis\",\"precision\":\"double\",\"size\":[%d,%d]}\n", W, H);
        for (auto& o : scene) {
            out("{\"object\":\"%s\"", o.name);
            if (o.shape == QUAD)
                out(",\"rectangle\":{\"corner\":[%.17g,%.17g,%.17g],\"a\":[%.17g,%.17g,%.17g],\"b\":[%.17g,%.17g,%.17g]}}\n",
                    o.c.x, o.c.y, o.c.z, o.a.x, o.a.y, o.a.z, o.b.x, o.b.y, o.b.z);
            else
                out(",\"sphere\":{\"center\":[%.17g,%.17g,%.17g],\"radius\":%.17g}}\n", o.c.x, o.c.y, o.c.z, o.r);
        }
        for (int i : lights) out("{\"lamp\":\"%s\",\"object\":\"%s\"}\n", scene[i].name, scene[i].name);
    }

    const V eye = {0, 1, 3.6};
    const double half = std::tan(40 * PI / 180 / 2);
    printf("P3\n%d %d\n255\n", W, H);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            logging = flog && x % every == 0 && y % every == 0;
            px = x; py = y;
            V sum = O;
            for (int s = 0; s < SPP; s++) {
                smp = s; ids = 0;
                Rng g(uint64_t(y * W + x) * SPP + s, 7);
                double sx = (2 * (x + g.uni()) / W - 1) * half * W / H;
                double sy = (1 - 2 * (y + g.uni()) / H) * half;
                V d = unit({sx, sy, -1});
                sum = sum + radiance(eye, d, g);
            }
            sum = sum / SPP;
            auto byte = [](double v) { return (int)(255 * std::pow(std::min(1.0, std::max(0.0, v)), 1 / 2.2) + .5); };
            printf("%d %d %d\n", byte(sum.x), byte(sum.y), byte(sum.z));
        }
    if (flog) fclose(flog);
}
