// ow.cpp -- my weekend ray tracer.  g++ -O2 -std=c++17 -o ow ow.cpp ; ./ow > ow.ppm
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

using std::shared_ptr;
using std::make_shared;

const float infinity = std::numeric_limits<float>::infinity();
const float pi = 3.1415926535897932385f;

static std::mt19937 rng(1);
inline float random_float() {
    return (rng() >> 8) * (1.0f / 16777216.0f);
}
inline float random_float(float a, float b) { return a + (b - a) * random_float(); }
inline float degrees_to_radians(float d) { return d * pi / 180.0f; }

// ---------------------------------------------------------------- vec3
class vec3 {
public:
    float e[3];
    vec3() : e{0, 0, 0} {}
    vec3(float a, float b, float c) : e{a, b, c} {}
    float x() const { return e[0]; }
    float y() const { return e[1]; }
    float z() const { return e[2]; }
    vec3 operator-() const { return vec3(-e[0], -e[1], -e[2]); }
    float operator[](int i) const { return e[i]; }
    float& operator[](int i) { return e[i]; }
    vec3& operator+=(const vec3& v) { e[0] += v[0]; e[1] += v[1]; e[2] += v[2]; return *this; }
    float length_squared() const { return e[0] * e[0] + e[1] * e[1] + e[2] * e[2]; }
    float length() const { return std::sqrt(length_squared()); }
    bool near_zero() const {
        const float s = 1e-6f;
        return std::fabs(e[0]) < s && std::fabs(e[1]) < s && std::fabs(e[2]) < s;
    }
};
using point3 = vec3;
using color = vec3;

inline vec3 operator+(const vec3& u, const vec3& v) { return vec3(u[0] + v[0], u[1] + v[1], u[2] + v[2]); }
inline vec3 operator-(const vec3& u, const vec3& v) { return vec3(u[0] - v[0], u[1] - v[1], u[2] - v[2]); }
inline vec3 operator*(const vec3& u, const vec3& v) { return vec3(u[0] * v[0], u[1] * v[1], u[2] * v[2]); }
inline vec3 operator*(float t, const vec3& v) { return vec3(t * v[0], t * v[1], t * v[2]); }
inline vec3 operator*(const vec3& v, float t) { return t * v; }
inline vec3 operator/(const vec3& v, float t) { return (1 / t) * v; }
inline float dot(const vec3& u, const vec3& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
inline vec3 cross(const vec3& u, const vec3& v) {
    return vec3(u[1] * v[2] - u[2] * v[1],
                u[2] * v[0] - u[0] * v[2],
                u[0] * v[1] - u[1] * v[0]);
}
inline vec3 unit_vector(const vec3& v) { return v / v.length(); }

inline vec3 random_unit_vector() {
    while (true) {
        vec3 p(random_float(-1, 1), random_float(-1, 1), random_float(-1, 1));
        float l = p.length_squared();
        if (1e-20f < l && l <= 1) return p / std::sqrt(l);
    }
}
inline vec3 random_in_unit_disk() {
    while (true) {
        vec3 p(random_float(-1, 1), random_float(-1, 1), 0);
        if (p.length_squared() < 1) return p;
    }
}
inline vec3 reflect(const vec3& v, const vec3& n) { return v - 2 * dot(v, n) * n; }
inline vec3 refract(const vec3& uv, const vec3& n, float etai_over_etat) {
    float cos_theta = std::fmin(dot(-uv, n), 1.0f);
    vec3 r_out_perp = etai_over_etat * (uv + cos_theta * n);
    vec3 r_out_parallel = -std::sqrt(std::fabs(1.0f - r_out_perp.length_squared())) * n;
    return r_out_perp + r_out_parallel;
}

// ---------------------------------------------------------------- ray, hit
class ray {
public:
    ray() {}
    ray(const point3& o, const vec3& d) : orig(o), dir(d) {}
    const point3& origin() const { return orig; }
    const vec3& direction() const { return dir; }
    point3 at(float t) const { return orig + t * dir; }
private:
    point3 orig;
    vec3 dir;
};

class material;
class hit_record {
public:
    point3 p;
    vec3 normal;
    shared_ptr<material> mat;
    float t;
    bool front_face;
    const char* name;
    void set_face_normal(const ray& r, const vec3& outward_normal) {
        front_face = dot(r.direction(), outward_normal) < 0;
        normal = front_face ? outward_normal : -outward_normal;
    }
};

class sphere {
public:
    sphere(const char* name, const point3& c, float r, shared_ptr<material> m)
        : name(name), center(c), radius(r), mat(m) {}
    bool hit(const ray& r, float t_min, float t_max, hit_record& rec) const {
        vec3 oc = r.origin() - center;
        float a = r.direction().length_squared();
        float half_b = dot(oc, r.direction());
        float c = oc.length_squared() - radius * radius;
        float discriminant = half_b * half_b - a * c;
        if (discriminant < 0) return false;
        float sqrtd = std::sqrt(discriminant);
        float root = (-half_b - sqrtd) / a;
        if (root <= t_min || t_max <= root) {
            root = (-half_b + sqrtd) / a;
            if (root <= t_min || t_max <= root)
                return false;
        }
        rec.t = root;
        rec.p = r.at(rec.t);
        vec3 outward_normal = (rec.p - center) / radius;
        rec.set_face_normal(r, outward_normal);
        rec.mat = mat;
        rec.name = name;
        return true;
    }
    const char* name;
    point3 center;
    float radius;
    shared_ptr<material> mat;
};

class hittable_list {
public:
    std::vector<sphere> objects;
    void add(const sphere& s) { objects.push_back(s); }
    bool hit(const ray& r, float t_min, float t_max, hit_record& rec) const {
        hit_record temp_rec;
        bool hit_anything = false;
        float closest_so_far = t_max;
        for (const auto& object : objects) {
            if (object.hit(r, t_min, closest_so_far, temp_rec)) {
                hit_anything = true;
                closest_so_far = temp_rec.t;
                rec = temp_rec;
            }
        }
        return hit_anything;
    }
};

// ---------------------------------------------------------------- materials
struct scatter_record {
    const char* kind = "diffuse";
    color attenuation;
    ray scattered;
    float eta = 0;       // dielectric only
    float choice = 1;    // Schlick: with which probability we went this way
};

class material {
public:
    virtual ~material() {}
    virtual bool scatter(const ray& r_in, const hit_record& rec, scatter_record& s) const = 0;
};

class lambertian : public material {
public:
    lambertian(const color& a) : albedo(a) {}
    bool scatter(const ray&, const hit_record& rec, scatter_record& s) const override {
        vec3 scatter_direction = rec.normal + random_unit_vector();
        if (scatter_direction.near_zero()) scatter_direction = rec.normal;
        s.kind = "diffuse";
        s.scattered = ray(rec.p, scatter_direction);
        s.attenuation = albedo;
        return true;
    }
    color albedo;
};

class metal : public material {
public:
    metal(const color& a, float f) : albedo(a), fuzz(f < 1 ? f : 1) {}
    bool scatter(const ray& r_in, const hit_record& rec, scatter_record& s) const override {
        vec3 reflected = reflect(unit_vector(r_in.direction()), rec.normal);
        if (fuzz > 0) reflected += fuzz * random_unit_vector();
        s.kind = fuzz > 0 ? "glossy" : "reflected";
        s.scattered = ray(rec.p, reflected);
        s.attenuation = albedo;
        return dot(s.scattered.direction(), rec.normal) > 0;
    }
    color albedo;
    float fuzz;
};

class dielectric : public material {
public:
    dielectric(float ri) : refraction_index(ri) {}
    bool scatter(const ray& r_in, const hit_record& rec, scatter_record& s) const override {
        s.attenuation = color(1, 1, 1);
        float ri = rec.front_face ? 1.0f / refraction_index : refraction_index;
        vec3 unit_direction = unit_vector(r_in.direction());
        float cos_theta = std::fmin(dot(-unit_direction, rec.normal), 1.0f);
        float sin_theta = std::sqrt(1.0f - cos_theta * cos_theta);
        bool cannot_refract = ri * sin_theta > 1.0f;
        float R = cannot_refract ? 1.0f : reflectance(cos_theta, ri);
        vec3 direction;
        if (R > random_float()) {
            direction = reflect(unit_direction, rec.normal);
            s.kind = "reflected";
            s.choice = R;
        } else {
            direction = refract(unit_direction, rec.normal, ri);
            s.kind = "transmitted";
            s.choice = 1 - R;
            s.eta = ri;
        }
        s.scattered = ray(rec.p, direction);
        return true;
    }
    float refraction_index;
private:
    static float reflectance(float cosine, float ri) {
        float r0 = (1 - ri) / (1 + ri);
        r0 = r0 * r0;
        return r0 + (1 - r0) * std::pow(1 - cosine, 5.0f);
    }
};

// ---------------------------------------------------------------- my log of rays
FILE* rlog = nullptr;
bool log_on = false;
int log_i, log_j, log_s, ray_count;

// ---------------------------------------------------------------- trace
color sky(const ray& r) {
    vec3 unit_direction = unit_vector(r.direction());
    float a = 0.5f * (unit_direction.y() + 1.0f);
    return (1.0f - a) * color(1.0f, 1.0f, 1.0f) + a * color(0.5f, 0.7f, 1.0f);
}

color ray_color(const ray& r, const hittable_list& world, int depth, int parent, const scatter_record& how) {
    if (depth <= 0) return color(0, 0, 0);
    int id = ray_count++;
    hit_record rec;
    color result;
    bool hit = world.hit(r, 0.001f, infinity, rec);
    if (!hit) {
        result = sky(r);
    } else {
        scatter_record s;
        if (rec.mat->scatter(r, rec, s))
            result = s.attenuation * ray_color(s.scattered, world, depth - 1, id, s);
        else
            result = color(0, 0, 0);
    }
    if (log_on) {
        fprintf(rlog, "{\"pixel\":[%d,%d],\"sample\":%d,\"ray\":%d,", log_i, log_j, log_s, id);
        if (parent >= 0) fprintf(rlog, "\"parent\":%d,\"weight\":[%.9g,%.9g,%.9g],", parent,
                                 how.attenuation[0], how.attenuation[1], how.attenuation[2]);
        if (how.eta != 0) fprintf(rlog, "\"eta\":%.9g,", how.eta);
        if (how.choice != 1) fprintf(rlog, "\"choice\":%.9g,", how.choice);
        fprintf(rlog, "\"kind\":\"%s\",\"origin\":[%.9g,%.9g,%.9g],\"direction\":[%.9g,%.9g,%.9g],", how.kind,
                r.origin()[0], r.origin()[1], r.origin()[2], r.direction()[0], r.direction()[1], r.direction()[2]);
        if (hit) fprintf(rlog, "\"t\":%.9g,\"point\":[%.9g,%.9g,%.9g],\"normal\":[%.9g,%.9g,%.9g],\"front\":%s,\"object\":\"%s\",",
                         rec.t, rec.p[0], rec.p[1], rec.p[2], rec.normal[0], rec.normal[1], rec.normal[2],
                         rec.front_face ? "true" : "false", rec.name);
        fprintf(rlog, "\"radiance\":[%.9g,%.9g,%.9g]}\n", result[0], result[1], result[2]);
    }
    return result;
}

// ---------------------------------------------------------------- camera
class camera {
public:
    int image_width = 160, image_height = 120;
    float vfov = 35;
    point3 lookfrom = point3(-1.4f, 1.1f, 2.6f), lookat = point3(0, 0, -1);
    vec3 vup = vec3(0, 1, 0);
    float defocus_angle = 0.6f, focus_dist = 3.9f;

    void initialize() {
        float theta = degrees_to_radians(vfov);
        float h = std::tan(theta / 2);
        float viewport_height = 2 * h * focus_dist;
        float viewport_width = viewport_height * (float(image_width) / image_height);
        w = unit_vector(lookfrom - lookat);
        u = unit_vector(cross(vup, w));
        v = cross(w, u);
        vec3 viewport_u = viewport_width * u;
        vec3 viewport_v = viewport_height * -v;
        pixel_delta_u = viewport_u / image_width;
        pixel_delta_v = viewport_v / image_height;
        point3 upper_left = lookfrom - focus_dist * w - viewport_u / 2 - viewport_v / 2;
        pixel00 = upper_left + 0.5f * (pixel_delta_u + pixel_delta_v);
        float defocus_radius = focus_dist * std::tan(degrees_to_radians(defocus_angle / 2));
        disk_u = u * defocus_radius;
        disk_v = v * defocus_radius;
    }
    ray get_ray(int i, int j) const {
        float ox = random_float() - 0.5f, oy = random_float() - 0.5f;
        point3 sample = pixel00 + (i + ox) * pixel_delta_u + (j + oy) * pixel_delta_v;
        vec3 d = random_in_unit_disk();
        point3 o = lookfrom + d[0] * disk_u + d[1] * disk_v;
        return ray(o, sample - o);
    }
private:
    vec3 u, v, w, pixel_delta_u, pixel_delta_v, disk_u, disk_v;
    point3 pixel00;
};

inline float linear_to_gamma(float x) { return x > 0 ? std::sqrt(x) : 0; }
inline int to_byte(float x) { x = linear_to_gamma(x); return int(256 * (x < 0 ? 0 : x > 0.999f ? 0.999f : x)); }

int main() {
    hittable_list world;
    world.add(sphere("ground", point3(0, -100.5f, -1), 100, make_shared<lambertian>(color(0.8f, 0.8f, 0.0f))));
    world.add(sphere("center", point3(0, 0, -1), 0.5f, make_shared<lambertian>(color(0.1f, 0.2f, 0.5f))));
    world.add(sphere("glass", point3(-1, 0, -1), 0.5f, make_shared<dielectric>(1.5f)));
    world.add(sphere("bubble", point3(-1, 0, -1), 0.4f, make_shared<dielectric>(1.0f / 1.5f)));
    world.add(sphere("gold", point3(1, 0, -1), 0.5f, make_shared<metal>(color(0.8f, 0.6f, 0.2f), 0.3f)));
    world.add(sphere("mirror", point3(-0.45f, -0.3f, -0.25f), 0.2f, make_shared<metal>(color(0.8f, 0.8f, 0.8f), 0.0f)));
    world.add(sphere("marble", point3(0.3f, -0.35f, -0.2f), 0.15f, make_shared<dielectric>(1.5f)));
    world.add(sphere("pea", point3(0.65f, -0.4f, -0.1f), 0.1f, make_shared<lambertian>(color(0.2f, 0.7f, 0.3f))));

    camera cam;
    cam.initialize();
    const int samples_per_pixel = 16, max_depth = 50;

    int every = 1;
    if (const char* s = getenv("RAYS")) every = atoi(s + (s[0] == '/'));
    if (every < 1) every = 1;
    if (const char* f = getenv("LOG")) {
        rlog = fopen(f, "w");
        fprintf(rlog, "{\"rays\":1,\"program\":\"ow\",\"precision\":\"single\",\"size\":[%d,%d]}\n", cam.image_width, cam.image_height);
        for (auto& s : world.objects)
            fprintf(rlog, "{\"object\":\"%s\",\"sphere\":{\"center\":[%.9g,%.9g,%.9g],\"radius\":%.9g}}\n",
                    s.name, s.center[0], s.center[1], s.center[2], s.radius);
    }
    printf("P3\n%d %d\n255\n", cam.image_width, cam.image_height);
    for (int j = 0; j < cam.image_height; j++)
        for (int i = 0; i < cam.image_width; i++) {
            color pixel(0, 0, 0);
            log_on = rlog && i % every == 0 && j % every == 0;
            log_i = i; log_j = j;
            rng.seed(j * cam.image_width + i);    // so that a pixel is the same every time
            for (int s = 0; s < samples_per_pixel; s++) {
                log_s = s; ray_count = 0;
                ray r = cam.get_ray(i, j);
                scatter_record first;
                first.kind = "camera";
                pixel += ray_color(r, world, max_depth, -1, first);
            }
            pixel = pixel / samples_per_pixel;
            printf("%d %d %d\n", to_byte(pixel[0]), to_byte(pixel[1]), to_byte(pixel[2]));
        }
    if (rlog) fclose(rlog);
}
