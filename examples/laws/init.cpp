// Answers the questions of `groundtruth laws`: name your lobes, and fill in two functions.
//
// Build: c++ -std=c++17 -O2 -o my_bsdfs my_bsdfs.cpp
// Run:   groundtruth laws -- ./my_bsdfs
//
// docs/laws.md describes the questions and the claims, and examples/laws/bsdfs.py is one with more lobes.
// All directions are unit vectors in the local frame of the surface: z is the normal. `wo` points to the viewer, `wi`
// to the light. The lobe below is Lambert's; put yours in its place.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// Names of its own: yours, and those of headers with `using namespace std;`, stay apart.
namespace laws {

@JSON@
// What you have: names, from where parameters are drawn, and what you claim. A claim that is left out is not tested.
// [0, 1] is a range; {"one_of": ["copper", "gold"]} chooses, a number is fixed.
const char* LOBES = R"([
    {"name": "lambert", "parameters": {"albedo": [0, 1]}, "claims": {"reciprocal": true, "isotropic": true}}
])";

using Vector = std::array<double, 3>;

const double PI = 3.14159265358979323846;

struct Value {
    Vector f;  // without a cosine
    double pdf;  // the density of `sample` at wi, per steradian
};

Value evaluate(const std::string& name, const Json& parameters, Vector wo, Vector wi) {
    if (wo[2] <= 0 || wi[2] <= 0) return {{0, 0, 0}, 0};
    double f = parameters["albedo"].real() / PI;
    return {{f, f, f}, wi[2] / PI};
}

struct Sample {
    Vector wi;
    Vector weight;  // f |cos| / pdf
    double pdf;  // negative for a single direction, which has no density
};

// A direction for four random numbers in [0, 1), or nothing.
std::optional<Sample> sample(const std::string& name, const Json& parameters, Vector wo, const std::vector<double>& u) {
    if (wo[2] <= 0) return {};
    double r = std::sqrt(u[0]), phi = 2 * PI * u[1], albedo = parameters["albedo"].real();
    Vector wi = {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u[0])};
    return Sample{wi, {albedo, albedo, albedo}, wi[2] / PI};
}

// The protocol: a question is a line, and so is its answer, with the same id.

Vector vector(const Json& json) {
    auto all = json.reals();
    return {all.at(0), all.at(1), all.at(2)};
}

std::string joined(const std::vector<std::string>& items) {
    std::string all;
    for (auto& item : items) all += (all.empty() ? "" : ",") + item;
    return "[" + all + "]";
}

std::string answer(const Json& question) {
    if (question.has("list")) {
        std::string list = LOBES;
        std::replace(list.begin(), list.end(), '\n', ' ');
        return list;
    }
    bool is_eval = question.has("eval");
    const Json& data = question[is_eval ? "eval" : "sample"];
    const std::string& name = data["lobe"].text;
    const Json& parameters = data["parameters"];
    Vector wo = vector(data["wo"]);
    std::vector<std::string> first, second;
    if (is_eval) {
        for (const Json& wi : data["wi"].items) {
            Value value = evaluate(name, parameters, wo, vector(wi));
            first.push_back(list(value.f));
            second.push_back(text(value.pdf));
        }
        return object({{"f", joined(first)}, {"pdf", joined(second)}});
    }
    for (const Json& u : data["u"].items) {
        auto it = sample(name, parameters, wo, u.reals());
        std::string pdf = it && it->pdf >= 0 ? text(it->pdf) : "null";
        first.push_back(it ? object({{"wi", list(it->wi)}, {"weight", list(it->weight)}, {"pdf", pdf}}) : "null");
    }
    return joined(first);
}

std::string reply(const std::string& line) {
    Json question = Reader{line.c_str()}.value();
    std::string id = text(question["id"].number);
    try {
        return object({{"id", id}, {"answer", answer(question)}});
    } catch (const std::exception& error) {
        std::string words = error.what();
        for (char& c : words) if (c == '"' || c == '\\' || c < ' ') c = '\'';
        return object({{"id", id}, {"error", '"' + words + '"'}});
    }
}

}  // namespace laws

int main() {
    // endl flushes: a pipe keeps lines back. Print nothing else here: messages belong to std::cerr
    for (std::string line; std::getline(std::cin, line);) std::cout << laws::reply(line) << std::endl;
}
