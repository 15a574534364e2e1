// Writes down the rays of chosen pixels, one JSON object a line, for `groundtruth rays` (docs/rays.md). C++11 and later.
//
//   RAYS=120,80 ./my_tracer    writes rays.jsonl: the rays of that pixel; RAYS="120,80;121,80" of two,
//                              RAYS=10x10+120+80 of a block, RAYS=/16 of each 16th column and row
//   RAYS_FILE=other.jsonl      to another file
//
//   rays::pixel(x, y, sample);                        // before the camera's ray of a sample
//   rays::Ray log("reflected", origin, direction);    // where a ray begins: camera, reflected, transmitted, diffuse,
//                                                     // path, shadow; the ray around it is its parent
//   log.hit(t, point, normal, "ball");                // where it ends; not called if it hits nothing
//   log.number("pdf", pdf); log.color("weight", w);   // what else is known, and "radiance": what it brings back
//
// The line is written when `log` goes out of scope. Vectors have v[0], v.x or v.x(). Without RAYS a call tests a bool.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>

namespace rays {
struct State {
    bool on = false;                                // whether this thread is in a chosen pixel
    int x = 0, y = 0, sample = 0;
    long next = 0, open = -1;                       // the number of the next ray, and of the ray around it
};
inline State& state() { static thread_local State s; return s; }

// Whether the first item of a selection has the pixel; `rest` moves past the item, unless it is none.
inline bool has(const char*& rest, int px, int py) {
    int x = 0, y = 0, width = 0, height = 0, step = 1, n = 0;
    if (std::sscanf(rest, "%dx%d+%d+%d%n", &width, &height, &x, &y, &n) != 4) {
        if (std::sscanf(rest, "/%d%n", &step, &n) == 1) width = height = 1 << 30;
        else if (std::sscanf(rest, "%d,%d%n", &x, &y, &n) == 2) width = height = 1;
    }
    if (n == 0 || step < 1 || (rest[n] && rest[n] != ';')) return false;
    rest += n + (rest[n] == ';');
    return px >= x && py >= y && px - x < width && py - y < height && (px - x) % step == 0 && (py - y) % step == 0;
}

struct File {
    std::FILE* out = nullptr;
    const char* chosen = std::getenv("RAYS");
    std::mutex lock;
    File() {
        const char *name = std::getenv("RAYS_FILE"), *rest = chosen, *last = nullptr;
        while (rest && rest != last) { last = rest; has(rest, 0, 0); }
        if (rest && *rest) std::fprintf(stderr, "rays: RAYS is x,y or WxH+X+Y or /N, or several with ';', not %s\n", rest);
        if (!rest || !*chosen || *rest) return;
        out = std::fopen(name ? name : "rays.jsonl", "w");
        out ? line("{\"rays\": 1}") : std::perror("rays");
    }
    void line(const std::string& json) {
        std::lock_guard<std::mutex> guard(lock);
        std::fprintf(out, "%s\n", json.c_str());
        std::fflush(out);
    }
};
inline File& file() { static File& f = *new File; return f; }

// A line of its own, as {"object": "ball", "sphere": {"center": [0, 1, 0], "radius": 1}} or {"lamp": "sun", ...}
inline void line(const std::string& json) { if (file().out) file().line(json); }

inline void pixel(int x, int y, int sample = 0) {
    if (!file().out) return;
    State s; s.x = x; s.y = y; s.sample = sample;
    const char* rest = file().chosen;
    while (!s.on && *rest) s.on = has(rest, x, y);
    state() = s;
}

template <class V> auto at(const V& v, int i, int) -> decltype(double(v[0])) { return v[i]; }
template <class V> auto at(const V& v, int i, long) -> decltype(double(v.x)) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }
template <class V> auto at(const V& v, int i, char) -> decltype(double(v.x())) { return i == 0 ? v.x() : i == 1 ? v.y() : v.z(); }

class Ray {
    bool on;
    long own = 0, before = -1;
    std::string line;
    template <class T> void print(const char* format, T value) {
        char text[40];
        std::snprintf(text, sizeof text, format, value);
        for (char* c = text; *c; ++c) line += *c == ',' ? '.' : *c;     // some locales have a decimal comma
    }
    void name(const char* field) { line += line.empty() ? "{\"" : ", \""; line += field; line += "\": "; }
public:
    template <class P, class V> Ray(const char* kind, const P& origin, const V& direction) : on(state().on) {
        if (!on) return;
        State& s = state();
        own = s.next++; before = s.open; s.open = own;
        name("pixel"); line += "[" + std::to_string(s.x) + ", " + std::to_string(s.y) + "]";
        number("sample", s.sample); number("ray", own);
        if (before >= 0) number("parent", before);
        text("kind", kind); color("origin", origin); color("direction", direction);
    }
    Ray(const Ray&) = delete;
    ~Ray() { if (on) { if (state().open >= own) state().open = before; file().line(line + "}"); } }
    void number(const char* field, double x) { if (on) { name(field); print("%.17g", x); } }
    void flag(const char* field, bool x) { if (on) { name(field); line += x ? "true" : "false"; } }
    template <class V> void color(const char* field, const V& v) {
        if (!on) return;
        name(field);
        for (int i : {0, 1, 2}) { line += i ? ", " : "["; print("%.17g", at(v, i, 0)); }
        line += ']';
    }
    void text(const char* field, const std::string& value) { if (on) text(field, value.c_str()); }
    void text(const char* field, const char* value) {
        if (!on) return;
        name(field); line += '"';
        for (; *value; ++value) {
            if (*value == '"' || *value == '\\') line += '\\';
            (unsigned char)*value < 32 ? print("\\u%04x", *value) : line.push_back(*value);
        }
        line += '"';
    }
    template <class P, class V> void hit(double t, const P& point, const V& normal, const char* object = nullptr) {
        number("t", t); color("point", point); color("normal", normal);
        if (object) text("object", object);
    }
};
}  // namespace rays
