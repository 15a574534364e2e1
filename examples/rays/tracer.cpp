// A small tracer that writes down its rays: spheres over a floor, a mirror, glass, a point lamp, one path a sample, in
// single precision.
//     c++ -O2 -std=c++11 -I. tracer.cpp -o tracer && RAYS=/8 ./tracer > picture.ppm && groundtruth rays rays.jsonl
#include "rays.h"

#include <algorithm>
#include <random>

struct Vec {
    float x, y, z;
    Vec operator+(Vec b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vec operator-(Vec b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vec operator*(Vec b) const { return {x * b.x, y * b.y, z * b.z}; }
    Vec operator*(float s) const { return {x * s, y * s, z * s}; }
    Vec operator-() const { return {-x, -y, -z}; }
};
static float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static Vec unit(Vec a) { return a * (1 / std::sqrt(dot(a, a))); }

static const float PI = 3.14159265f, FAR = 1e30f, NEAR = 1e-3f;
enum Look { MATTE, MIRROR, GLASS };
struct Ball { const char* name; Vec center; float radius; Look look; Vec color; };
static const Ball balls[] = {
    {"floor", {0, -100, 0}, 100, MATTE, {0.5f, 0.5f, 0.5f}},
    {"red", {-1.1f, 1, 0}, 1, MATTE, {0.8f, 0.2f, 0.2f}},
    {"mirror", {1.1f, 1, -0.5f}, 1, MIRROR, {0.9f, 0.9f, 0.9f}},
    {"glass", {0.2f, 0.6f, 1.6f}, 0.6f, GLASS, {1, 1, 1}},
};
static const Vec lamp = {4, 6, 5}, power = {60, 60, 60};

struct Hit { float t; Vec point, normal; const Ball* ball; };

static bool hit(Vec o, Vec d, float least, float most, Hit& found) {
    found.t = most;
    found.ball = nullptr;
    for (const Ball& ball : balls) {
        Vec between = o - ball.center;
        float a = dot(d, d), half = dot(between, d), c = dot(between, between) - ball.radius * ball.radius;
        float square = half * half - a * c;
        if (square < 0) continue;
        for (float t : {(-half - std::sqrt(square)) / a, (-half + std::sqrt(square)) / a}) {
            if (t <= least || t >= found.t) continue;
            found.t = t;
            found.ball = &ball;
            break;
        }
    }
    if (!found.ball) return false;
    found.point = o + d * found.t;
    found.normal = unit(found.point - found.ball->center);
    return true;
}

static thread_local std::mt19937 generator;
static float random01() { return std::uniform_real_distribution<float>(0, 1)(generator); }

static Vec direct(const Hit& at, Vec normal, Vec f) {
    Vec way = lamp - at.point, start = at.point + normal * NEAR;
    float square = dot(way, way), cosine = dot(way, normal) / std::sqrt(square);
    if (cosine <= 0) return {0, 0, 0};
    rays::Ray log("shadow", start, way);
    log.text("light", "lamp");
    log.number("end", 1);
    Hit blocker;
    if (hit(start, way, 1e-4f, 1, blocker)) {
        log.number("t", blocker.t);
        log.text("object", blocker.ball->name);
        return {0, 0, 0};
    }
    return f * power * (cosine / square);
}

// what a ray's radiance is multiplied by; 0 is not known, or not there
struct Factors { Vec weight; float pdf, cosine, choice, eta; Vec f; };

static Vec radiance(const char* kind, Vec o, Vec d, int depth, Factors by) {
    rays::Ray log(kind, o, d);
    log.color("weight", by.weight);
    if (by.pdf > 0) { log.number("pdf", by.pdf); log.number("cos", by.cosine); log.color("f", by.f); }
    if (by.eta > 0) log.number("eta", by.eta);
    Hit at;
    Vec sum = {0, 0, 0};
    if (!hit(o, d, NEAR, FAR, at)) {
        sum = Vec{0.5f, 0.7f, 1.0f} * (0.5f + 0.5f * unit(d).y);
        log.color("emitted", sum);
    } else {
        log.hit(at.t, at.point, at.normal, at.ball->name);
        bool inside = dot(d, at.normal) > 0;
        Vec n = inside ? -at.normal : at.normal;
        Vec lit = at.ball->look == MATTE ? direct(at, n, at.ball->color * (1 / PI)) : Vec{0, 0, 0};
        log.color("direct", lit);
        sum = lit;
        float cosine = -dot(unit(d), n);
        if (depth == 0) {
        } else if (at.ball->look == MATTE) {
            float u = random01(), phi = 2 * PI * random01(), r = std::sqrt(u);
            Vec s = unit(cross(std::fabs(n.x) > 0.9f ? Vec{0, 1, 0} : Vec{1, 0, 0}, n)), t = cross(n, s);
            Vec next = s * (r * std::cos(phi)) + t * (r * std::sin(phi)) + n * std::sqrt(1 - u);
            float next_cosine = dot(next, n), pdf = next_cosine / PI;
            Vec f = at.ball->color * (1 / PI), weight = f * (next_cosine / pdf);
            sum = sum + weight * radiance("diffuse", at.point, next, depth - 1, {weight, pdf, next_cosine, 1, 0, f});
        } else if (at.ball->look == MIRROR) {
            sum = sum + at.ball->color * radiance("reflected", at.point, d - n * (2 * dot(d, n)), depth - 1, {at.ball->color, 0, 0, 1, 0, {}});
        } else {
            float ratio = inside ? 1.5f : 1 / 1.5f, sine = ratio * std::sqrt(std::max(0.0f, 1 - cosine * cosine));
            float outside = inside ? std::sqrt(std::max(0.0f, 1 - sine * sine)) : cosine;
            float r0 = 0.04f, schlick = r0 + (1 - r0) * std::pow(1 - outside, 5.0f);
            Vec one = {1, 1, 1};
            if (sine >= 1 || random01() < schlick) {
                sum = sum + radiance("reflected", at.point, d - n * (2 * dot(d, n)), depth - 1, {one, 0, 0, schlick, 0, {}});
            } else {
                Vec in = unit(d), across = (in + n * cosine) * ratio;
                Vec next = across - n * std::sqrt(std::fabs(1 - dot(across, across)));
                sum = sum + radiance("transmitted", at.point, next, depth - 1, {one, 0, 0, 1 - schlick, 1 / ratio, {}});
            }
        }
    }
    log.color("radiance", sum);
    return sum;
}

int main() {
    const int width = 160, height = 120, samples = 4;
    for (const Ball& ball : balls) {
        char line[200];
        std::snprintf(line, sizeof line, "{\"object\": \"%s\", \"sphere\": {\"center\": [%.9g, %.9g, %.9g], \"radius\": %.9g}}", ball.name,
                      ball.center.x, ball.center.y, ball.center.z, ball.radius);
        rays::line(line);
    }
    rays::line("{\"lamp\": \"lamp\", \"point\": [4, 6, 5]}");
    std::printf("P3\n%d %d\n255\n", width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            generator.seed(unsigned(y * width + x));
            Vec sum = {0, 0, 0};
            for (int sample = 0; sample < samples; ++sample) {
                rays::pixel(x, y, sample);
                float px = (x + random01() - 0.5f * width) / height, py = (0.5f * height - y - random01()) / height;
                Vec eye = {0, 2, 8}, to = {px, py - 0.15f, -1.2f};
                sum = sum + radiance("camera", eye, unit(to), 6, {{1, 1, 1}, 0, 0, 1, 0, {}});
            }
            auto byte = [&](float light) { return int(255.99f * std::sqrt(std::min(1.0f, light / samples))); };
            std::printf("%d %d %d\n", byte(sum.x), byte(sum.y), byte(sum.z));
        }
    }
}
