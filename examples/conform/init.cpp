// Answers the questions of `groundtruth conform`: fill in what your ray tracer has.
//
// Build: c++ -std=c++17 -O2 -o my_tracer my_tracer.cpp
// Run:   groundtruth conform -- ./my_tracer
//
// docs/probe.md describes the questions, docs/conform.md the run, and examples/conform/adapter.cpp is one filled in.
// What you do not have is unsupported: throw Unsupported, also for one shape among others. A function that is filled
// in begins, for example, with
//     std::vector<double> origin = q["ray"]["origin"].reals();
// and ends with
//     return object({{"t", text(t)}, {"normal", list(normal)}});
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

// The questions: each function gets a question's data and returns the answer.

// {"shape": …, "ray": {"origin": […], "direction": […]}} -> {"t": …, "normal": […]} or null
std::string intersect(const Json&) { throw Unsupported("intersect"); }

// {"shape": …, "segment": {"from": […], "to": […]}} -> true or false
std::string occluded(const Json&) { throw Unsupported("occluded"); }

// {"camera": …, "image": …, "pixel": [x, y]} -> {"origin": […], "direction": […]}
std::string camera_ray(const Json&) { throw Unsupported("camera_ray"); }

// {"camera": …, "image": …, "point": […]} -> {"image": [x, y]} or null
std::string project(const Json&) { throw Unsupported("project"); }

// {"sampler": …, "n": 16, "seed": 1, "sets": 2} -> [[[x, y], …], …]
std::string samples(const Json&) { throw Unsupported("samples"); }

// {"to": …, "u": [a, b]} -> a point; {"to": …, "point": […]} -> [a, b]
std::string map(const Json&) { throw Unsupported("map"); }

// {"lobe": …, "wo": […], "wi": […]} -> {"f": [r, g, b], "pdf": …, "albedo": [r, g, b]}
std::string lobe(const Json&) { throw Unsupported("lobe"); }

// {"eta": …, "cos_i": …} -> {"reflected": …, "transmitted": …}
std::string fresnel(const Json&) { throw Unsupported("fresnel"); }

// {"light": …, "from": […]} -> {"direction": […], "distance": …, "radiance": [r, g, b]}
std::string light(const Json&) { throw Unsupported("light"); }

// {"texture": …, "point": […]} -> [r, g, b]
std::string texture(const Json&) { throw Unsupported("texture"); }

// {"mapping": "spherical", "point": […]} -> [u, v]
std::string mapping(const Json&) { throw Unsupported("mapping"); }

// {"noise": …, "point": […]} -> {"value": …, "fbm": …, "turbulence": …}
std::string noise(const Json&) { throw Unsupported("noise"); }

// {"steps": […]} -> {"matrix": [three rows of four], "inverse": [three rows of four]}
std::string transform(const Json&) { throw Unsupported("transform"); }

// {"boxes": […], "multiplier": 2} -> {"resolution": [nx, ny, nz]}
std::string grid(const Json&) { throw Unsupported("grid"); }

// {"scene": …, "ray": …} -> {"mean": [r, g, b]}
std::string radiance(const Json&) { throw Unsupported("radiance"); }

// {"scene": …, "ray": …} -> {"radiance": [r, g, b], "rays": [{"kind": "camera", "origin": …, "direction": …}, …]}
std::string trace(const Json&) { throw Unsupported("trace"); }

const std::map<std::string, std::string (*)(const Json&)> QUESTIONS = {
    {"intersect", intersect}, {"occluded", occluded}, {"camera_ray", camera_ray}, {"project", project},
    {"samples", samples}, {"map", map}, {"lobe", lobe}, {"fresnel", fresnel}, {"light", light},
    {"texture", texture}, {"mapping", mapping}, {"noise", noise}, {"transform", transform}, {"grid", grid},
    {"radiance", radiance},
    {"trace", trace},
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
