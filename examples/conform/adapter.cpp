// Answers `groundtruth conform` for spheres, planes, triangles, Lambertian surfaces, Fresnel's equations and the
// pinhole camera, and says "unsupported" to all else. Every answer is right.
//
// Build: c++ -std=c++17 -O2 -o adapter examples/conform/adapter.cpp
// Run:   groundtruth conform -- ./adapter
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

// Names of its own: yours, and those of headers with `using namespace std;`, stay apart.
namespace conform {

struct Unsupported : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// JSON: a value is null, true or false, a number, a text, a list, or an object.

struct Json {
    enum Kind { Null, Truth, Number, Text, List, Object } kind = Null;
    double number = 0;              // of a truth: 0 or 1
    std::string text;
    std::vector<std::string> keys;  // of an object
    std::vector<Json> items;        // of a list; of an object, in the order of its keys

    bool has(const std::string& key) const { return std::find(keys.begin(), keys.end(), key) != keys.end(); }
    const Json& operator[](const std::string& key) const {
        auto at = std::find(keys.begin(), keys.end(), key);
        if (at == keys.end()) throw std::runtime_error("no field " + key);
        return items.at(at - keys.begin());
    }
    double real() const { return kind == Text ? std::strtod(text.c_str(), nullptr) : number; }  // "inf", too
    double real(const std::string& key, double otherwise) const { return has(key) ? (*this)[key].real() : otherwise; }
    std::vector<double> reals() const {
        std::vector<double> all;
        for (const Json& item : items) all.push_back(item.real());
        return all;
    }
};

struct Reader {
    const char* at;

    char next() { while (*at == ' ') ++at; return *at; }
    bool skip(char c) { bool is = next() == c; at += is; return is; }
    std::string text() {
        std::string text;
        for (skip('"'); *at && *at != '"'; ++at) text += *at == '\\' ? *++at : *at;  // names have no \n or \u
        skip('"');
        return text;
    }
    Json value() {
        Json json;
        if (skip('{')) {
            for (json.kind = Json::Object; *at && !skip('}'); skip(',')) {
                json.keys.push_back(text());
                skip(':');
                json.items.push_back(value());
            }
        } else if (skip('[')) {
            for (json.kind = Json::List; *at && !skip(']'); skip(',')) json.items.push_back(value());
        } else if (*at == '"') {
            json.kind = Json::Text;
            json.text = text();
        } else if (*at == 't' || *at == 'f' || *at == 'n') {
            json.kind = *at == 'n' ? Json::Null : Json::Truth;
            json.number = *at == 't';
            at += *at == 'f' ? 5 : 4;
        } else {
            char* end;
            json.kind = Json::Number;
            json.number = std::strtod(at, &end);
            if (end == at) throw std::runtime_error(std::string("not JSON: ") + at);
            at = end;
        }
        return json;
    }
};

// Answers are text. Numbers get as many digits as lead back to them.
std::string text(double x) {
    if (std::isinf(x)) return x > 0 ? "\"inf\"" : "\"-inf\"";
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.17g", x);
    return digits;
}

template <class Numbers> std::string list(const Numbers& numbers) {
    std::string all;
    for (double x : numbers) all += (all.empty() ? "" : ",") + text(x);
    return "[" + all + "]";
}

std::string object(std::initializer_list<std::pair<std::string, std::string>> fields) {
    std::string all;
    for (auto& [key, value] : fields) all += (all.empty() ? "\"" : ",\"") + key + "\":" + value;
    return "{" + all + "}";
}

// Vectors.

using Vector = std::array<double, 3>;

Vector vector(const Json& json) {
    std::vector<double> x = json.reals();
    return {x.at(0), x.at(1), x.at(2)};
}
Vector operator+(Vector a, Vector b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(Vector a, Vector b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(double k, Vector v) { return {k * v[0], k * v[1], k * v[2]}; }
double dot(Vector a, Vector b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(Vector v) { return std::hypot(v[0], v[1], v[2]); }
Vector unit(Vector v) { return 1 / length(v) * v; }

// ab − cd, with the digits that would cancel (Kahan)
double difference_of_products(double a, double b, double c, double d) {
    double cd = c * d;
    return std::fma(a, b, -cd) - std::fma(c, d, -cd);
}
Vector cross(Vector a, Vector b) {
    return {difference_of_products(a[1], b[2], a[2], b[1]), difference_of_products(a[2], b[0], a[0], b[2]),
            difference_of_products(a[0], b[1], a[1], b[0])};
}

// What rounding took from the difference a − b (Knuth)
Vector lost(Vector a, Vector b) {
    Vector difference = a - b, b_used = a - difference, a_used = difference + b_used;
    return (b_used - b) + (a - a_used);
}

// Shapes: each gives all hits on the whole line, ascending. Normals are unit and point outward.

struct Hit {
    double t;
    Vector normal;
};
using Hits = std::vector<Hit>;

Hits sphere(const Json& shape, Vector o, Vector d) {
    Vector f = o - vector(shape["center"]);
    double r = shape["radius"].real(), middle = -dot(f, d) / dot(d, d);
    // the point of the line nearest to the centre: b² − ac would lose all digits for a far origin
    Vector nearest = f + middle * d;
    double p = length(nearest);
    if (p > r) return {};
    double half = std::sqrt((r - p) * (r + p) / dot(d, d));
    return {{middle - half, unit(nearest - half * d)}, {middle + half, unit(nearest + half * d)}};
}

Hits plane(Vector point, Vector normal, Vector o, Vector d) {
    Vector n = unit(normal);
    double cosine = dot(d, n);
    return cosine != 0 ? Hits{{dot(point - o, n) / cosine, n}} : Hits{};
}

Hits triangle(const Json& shape, Vector o, Vector d) {
    auto& corners = shape["vertices"].items;
    Vector v[] = {vector(corners.at(0)), vector(corners.at(1)), vector(corners.at(2))}, side;
    // on which side of each edge the ray passes; differences first: the triangle may be small and far away
    for (int i = 0; i < 3; ++i) side[i] = dot(d, cross(v[(i + 1) % 3] - v[i], o - v[i]));
    auto [least, most] = std::minmax({side[0], side[1], side[2]});
    if (least < 0 && 0 < most) return {};
    // the corners of a thin triangle are almost on one line: what its edges lost in rounding turns its normal
    Vector a = v[1] - v[0], b = v[2] - v[0];
    Vector normal = cross(a, b) + (cross(a, lost(v[2], v[0])) + cross(lost(v[1], v[0]), b));
    return plane(v[0], normal, o, d);
}

Hits hits(const Json& q, Vector o, Vector d, double low, double high) {
    if (!q.has("shape")) throw Unsupported("a whole scene");
    const std::string& kind = q["shape"].keys.at(0);
    const Json& shape = q["shape"].items.at(0);
    if (q.has("transform") || shape.has("inward")) throw Unsupported("transform, inward");
    Hits all, inside;
    if (kind == "sphere") all = sphere(shape, o, d);
    else if (kind == "plane") all = plane(vector(shape["point"]), vector(shape["normal"]), o, d);
    else if (kind == "triangle") all = triangle(shape, o, d);
    else throw Unsupported(kind);
    for (Hit hit : all) if (low < hit.t && hit.t < high) inside.push_back(hit);
    return inside;
}

// The questions: each function gets a question's data and returns the answer.

std::string intersect(const Json& q) {
    std::vector<double> span = q.has("span") ? q["span"].reals() : std::vector<double>{0, INFINITY};
    std::string all;
    for (Hit hit : hits(q, vector(q["ray"]["origin"]), vector(q["ray"]["direction"]), span.at(0), span.at(1))) {
        std::string answer = object({{"t", text(hit.t)}, {"normal", list(hit.normal)}});
        if (q.real("all", 0) == 0) return answer;
        all += (all.empty() ? "" : ",") + answer;
    }
    return q.real("all", 0) == 0 ? "null" : "[" + all + "]";
}

std::string occluded(const Json& q) {
    if (!q.has("segment") || q.has("shapes")) throw Unsupported("occluded along a ray, or by a list of shapes");
    Vector from = vector(q["segment"]["from"]), to = vector(q["segment"]["to"]);
    return hits(q, from, to - from, 0, 1).empty() ? "false" : "true";
}

std::string lobe(const Json& q) {
    const double PI = std::acos(-1.0);
    if (!q["lobe"].has("lambertian")) throw Unsupported(q["lobe"].keys.at(0));
    Vector reflectance = vector(q["lobe"]["lambertian"]["reflectance"]);
    bool is_lit = vector(q["wo"])[2] > 0;
    std::string f = "null", pdf = "null", sample = "null";
    if (q.has("wi")) {
        double cosine = is_lit ? std::max(vector(q["wi"])[2], 0.0) : 0;
        f = list((cosine > 0 ? 1 / PI : 0) * reflectance);
        pdf = text(cosine / PI);
    }
    if (q.has("u") && is_lit) {
        std::vector<double> u = q["u"].reals();
        double phi = 2 * PI * u.at(0), cosine = std::sqrt(1 - u.at(1)), sine = std::sqrt((1 - cosine) * (1 + cosine));
        Vector wi = {sine * std::cos(phi), sine * std::sin(phi), cosine};
        sample = object({{"wi", list(wi)}, {"weight", list(reflectance)}, {"pdf", text(cosine / PI)}});
    }
    return object({{"albedo", list(is_lit * reflectance)}, {"f", f}, {"pdf", pdf}, {"sample", sample}});
}

std::string fresnel(const Json& q) {
    bool has_directions = q.has("wo");
    double eta = q["eta"].real(), cos_i = has_directions ? dot(vector(q["wo"]), vector(q["n"])) : q["cos_i"].real();
    double square = ((eta - 1) * (eta + 1) + cos_i * cos_i) / (eta * eta);  // of cos_t; no cancellation near η = 1
    if (square < 0) return object({{"reflected", "1"}, {"transmitted", "0"}, {"refracted", "null"}});
    double cos_t = std::sqrt(square);
    double r_s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    double r_p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    double reflected = (r_s * r_s + r_p * r_p) / 2;
    std::string refracted = "null";
    if (has_directions) {
        refracted = list(-1 / eta * vector(q["wo"]) - (cos_t - cos_i / eta) * vector(q["n"]));
    }
    return object({{"reflected", text(reflected)}, {"transmitted", text(1 - reflected)}, {"refracted", refracted}});
}

struct View {
    Vector eye, u, v, w;
    double distance, width, height, pixel_size;

    explicit View(const Json& q) {
        const Json &camera = q["camera"], &image = q["image"];
        if (!camera["lens"].has("pinhole") || camera.has("stereo")) throw Unsupported("this camera");
        const Json& lens = camera["lens"]["pinhole"];
        eye = vector(camera["eye"]);
        Vector look_at = camera.has("look_at") ? vector(camera["look_at"]) : Vector{0, 0, 0};
        Vector up = camera.has("up") ? vector(camera["up"]) : Vector{0, 1, 0};
        w = unit(eye - look_at);
        Vector level = unit(cross(up, w)), above = cross(w, level);
        double roll = camera.real("roll", 0) / 180 * std::acos(-1.0);
        u = std::cos(roll) * level + std::sin(roll) * above;
        v = std::cos(roll) * above - std::sin(roll) * level;
        distance = lens["distance"].real() * lens.real("zoom", 1);
        width = image["width"].real(), height = image["height"].real(), pixel_size = image.real("pixel_size", 1);
    }
};

std::string camera_ray(const Json& q) {
    View view(q);
    std::vector<double> pixel = q["pixel"].reals(), place{0.5, 0.5};
    if (q.has("place")) place = q["place"].reals();
    double x = view.pixel_size * (pixel.at(0) + place.at(0) - view.width / 2);
    double y = view.pixel_size * (view.height - 1 - pixel.at(1) + place.at(1) - view.height / 2);
    Vector direction = x * view.u + y * view.v - view.distance * view.w;
    return object({{"origin", list(view.eye)}, {"direction", list(unit(direction))}});
}

std::string project(const Json& q) {
    View view(q);
    Vector ahead = vector(q["point"]) - view.eye;
    double depth = -dot(ahead, view.w), scale = view.distance / (depth * view.pixel_size);
    double x = view.width / 2 + scale * dot(ahead, view.u), y = view.height / 2 - scale * dot(ahead, view.v);
    bool is_seen = depth > 0 && 0 <= x && x <= view.width && 0 <= y && y <= view.height;
    return is_seen ? object({{"image", list(std::array<double, 2>{x, y})}}) : "null";
}

const std::map<std::string, std::string (*)(const Json&)> QUESTIONS = {
    {"intersect", intersect}, {"occluded", occluded}, {"lobe", lobe},
    {"fresnel", fresnel}, {"camera_ray", camera_ray}, {"project", project},
};

// The protocol: a question is a line, and so is its answer, with the same id.
std::string reply(const std::string& line) {
    Json question = Reader{line.c_str()}.value();
    std::string id = text(question["id"].number), name, answer;
    for (auto& key : question.keys) if (key != "id") name = key;
    auto say = [&](const char* status, const std::string& value) { return object({{"id", id}, {status, value}}); };
    auto quoted = [](std::string words) {
        for (char& c : words) if (c == '"' || c == '\\' || c < ' ') c = '\'';
        return '"' + words + '"';
    };
    auto found = QUESTIONS.find(name);
    if (found == QUESTIONS.end()) return say("unsupported", quoted(name));
    try {
        return say("answer", found->second(question[name]));
    } catch (const Unsupported& what) {
        return say("unsupported", quoted(what.what()));
    } catch (const std::exception& error) {  // shown on the card, with the question; the next one is answered
        return say("error", quoted(error.what()));
    }
}

}  // namespace conform

int main() {
    // endl flushes: a pipe keeps lines back. Print nothing else here: messages belong to std::cerr
    for (std::string line; std::getline(std::cin, line);) std::cout << conform::reply(line) << std::endl;
}
