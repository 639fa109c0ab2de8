// A ray tracer for lessons 02 to 07 that writes its working: spheres, polygons, shadows, reflection.
//
//   c++ -std=c++17 -O2 tracer.cpp -o tracer          with nlohmann/json (Debian: nlohmann-json3-dev)
//   ./tracer SCENE.json > log.jsonl                  then: raystep check SCENE.json log.jsonl
//   ./tracer SCENE.json X,Y X,Y                      some pixels only
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>
#include <nlohmann/json.hpp>

using json = nlohmann::json;
using Vec = std::array<double, 3>;

#ifndef MISTAKE
#define MISTAKE ""  // a test plants one of those that the code below names
#endif
static bool planted(const char* name) { return std::string(MISTAKE) == name; }

const double EPSILON = 1e-6, INF = std::numeric_limits<double>::infinity();

static Vec operator+(Vec a, Vec b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
static Vec operator-(Vec a, Vec b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
static Vec operator*(double k, Vec a) { return {k * a[0], k * a[1], k * a[2]}; }
static Vec operator*(Vec a, Vec b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
static double dot(Vec a, Vec b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static Vec cross(Vec a, Vec b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
static double length(Vec a) { return std::sqrt(dot(a, a)); }
static Vec unit(Vec a) { return 1 / length(a) * a; }

struct Ray { int number; Vec origin, direction; };
struct Hit { double t; const json* object; };

struct Tracer {
    json scene;
    json pixel;
    int rays = 0;

    void log(const char* kind, std::optional<int> ray, json fields) {
        fields["kind"] = kind;
        fields["pixel"] = pixel;
        if (ray) fields["ray"] = *ray;
        std::cout << fields << '\n';
    }

    Ray start(const char* purpose, Vec origin, Vec direction, std::optional<int> parent = {}, json more = json::object()) {
        more["purpose"] = purpose;
        more["origin"] = origin;
        more["direction"] = direction;
        if (parent) more["parent"] = *parent;
        log("ray", rays, more);
        return {rays++, origin, direction};
    }

    // equation (iii), with half b: b′ = Δ·(o − c), t = (−b′ ∓ √(b′² − ac)) / a
    std::optional<double> sphere(const json& object, const Ray& ray, double least) {
        const json& ball = object["shape"]["sphere"];
        double radius = ball["radius"];
        Vec oc = ray.origin - ball["center"].get<Vec>();
        double a = dot(ray.direction, ray.direction), b = dot(ray.direction, oc), c = dot(oc, oc) - radius * radius;
        double discriminant = b * b - a * c;
        json fields = {{"object", object["name"]}, {"a", a}, {"b", b}, {"c", c}, {"discriminant", discriminant}};
        std::optional<double> t;
        if (discriminant >= 0) {
            double near = (-b - std::sqrt(discriminant)) / a, far = (-b + std::sqrt(discriminant)) / a;
            fields["near"] = near;
            fields["far"] = far;
            if (near > least) t = near;
            else if (far > least) t = far;
            if (planted("first root always")) t = near;
        }
        if (t) fields["t"] = *t;
        log("sphere_test", ray.number, fields);
        return t;
    }

    // equations (iv) and (v), then Fig. 15.57; the plane is not normalised
    std::optional<double> polygon(const json& object, const Ray& ray, double least) {
        std::vector<Vec> corners = object["shape"]["polygon"]["vertices"];
        Vec normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
        double d = -dot(normal, corners[0]), above = dot(normal, ray.origin) + (planted("sign of D") ? -d : d), down = dot(normal, ray.direction);
        if (down == 0) return {};
        double t = -above / down;
        bool ahead = t > least;
        json plane = {{"object", object["name"]}, {"numerator", above}, {"denominator", down}, {"root", t}};
        plane["plane"] = {normal[0], normal[1], normal[2], d};
        plane["verdict"] = ahead ? "hit" : "rejected";
        log("plane_test", ray.number, plane);
        if (!ahead) return {};
        Vec p = ray.origin + t * ray.direction;
        int drop = 0;
        for (int axis = 1; axis < 3; axis++)
            if (std::abs(normal[axis]) > std::abs(normal[drop])) drop = axis;
        int u = (drop + 1) % 3, v = (drop + 2) % 3;
        bool inside = false;
        for (size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
            Vec from = corners[j], to = corners[i];
            bool straddles = (from[v] > p[v]) != (to[v] > p[v]);
            // the half-line goes the other way than in the slides: the parity is the same
            if (straddles && from[u] + (p[v] - from[v]) / (to[v] - from[v]) * (to[u] - from[u]) < p[u]) inside = !inside;
        }
        log("polygon_test", ray.number, {{"object", object["name"]}, {"dropped", std::string(1, "xyz"[drop])},
                                         {"point", p}, {"inside", inside}});
        return inside ? std::optional<double>(t) : std::nullopt;
    }

    // the objects from the last to the first: the order is free
    std::optional<Hit> nearest(const Ray& ray, double least, double most) {
        std::optional<Hit> found;
        const json& objects = scene["objects"];
        for (size_t i = objects.size(); i-- > 0;) {
            auto t = objects[i]["shape"].contains("sphere") ? sphere(objects[i], ray, least) : polygon(objects[i], ray, least);
            if (t && *t < most && (!found || *t <= found->t)) found = Hit{*t, &objects[i]};
        }
        return found;
    }

    Vec colour(const Ray& ray, int depth) {
        auto hit = nearest(ray, depth == 1 ? 0 : EPSILON, INF);
        if (!hit) return scene["background"].get<Vec>();
        const json& object = *hit->object;
        log("ray_end", ray.number, {{"outcome", "hit"}, {"object", object["name"]}, {"t", hit->t}});
        Vec p = ray.origin + hit->t * ray.direction, normal;
        if (object["shape"].contains("sphere")) {
            const json& ball = object["shape"]["sphere"];
            normal = 1 / ball["radius"].get<double>() * (p - ball["center"].get<Vec>());
        } else {
            std::vector<Vec> corners = object["shape"]["polygon"]["vertices"];
            normal = unit(cross(corners[1] - corners[0], corners[2] - corners[0]));
        }
        if (dot(normal, ray.direction) > 0) normal = -1 * normal;
        const json& material = scene["materials"][object["material"].get<std::string>()];
        Vec own = material["colour"].get<Vec>(), sum = scene["ambient"].get<Vec>() * own, viewer = -1 * unit(ray.direction);
        // ε along the normal in place of an ε in t
        Vec from = p + EPSILON * normal;
        for (const json& light : scene["lights"]) {
            Vec shine = light["colour"].get<Vec>(), to = light["position"].get<Vec>() - p;
            double distance = length(to);
            to = unit(to);
            double cosine = dot(normal, to);
            Vec mirrored = 2 * cosine * normal - to;
            if (planted("R made of V")) mirrored = 2 * dot(normal, viewer) * normal - viewer;
            double highlight = dot(mirrored, viewer);
            double strength = std::pow(std::max(0.0, highlight), material.value("shininess", 1.0));
            Vec diffuse = std::max(0.0, cosine) * material.value("diffuse", 0.0) * (shine * own);
            Vec specular = (cosine > 0 ? material.value("specular", 0.0) * strength : 0.0) * shine;
            bool visible = cosine > 0;
            bool asked = !planted("first light only") || light == scene["lights"][0];
            if (visible && asked) {
                Ray shadow = start("shadow", from, to, ray.number, {{"light", light["name"]}});
                visible = !nearest(shadow, 0, distance);
            }
            log("light_term", ray.number, {{"light", light["name"]}, {"to_light", to}, {"n_dot_l", cosine}, {"r_dot_v", highlight},
                                           {"visibility", visible ? "visible" : cosine > 0 ? "shadowed" : "faces_away"},
                                           {"diffuse", diffuse}, {"specular", specular}});
            if (visible) sum = sum + diffuse + specular;
        }
        double weight = material.value("reflection", 0.0);
        if (weight > 0 && depth < scene.value("max_depth", 5)) {
            Vec d = unit(ray.direction);
            Ray child = start("reflected", from, d - 2 * dot(d, normal) * normal, ray.number);
            sum = sum + weight * colour(child, depth + 1);
        }
        return sum;
    }

    void trace(int x, int y) {
        const json& look = scene["camera"]["look_at"];
        double width = scene["camera"]["pixels"][0], height = scene["camera"]["pixels"][1];
        Vec cop = look["cop"].get<Vec>(), ahead = unit(look["target"].get<Vec>() - cop);
        Vec right = unit(cross(ahead, look["up"].get<Vec>())), up = cross(right, ahead);
        double size = 2 * std::tan(look["fov_degrees"].get<double>() * std::acos(-1.0) / 360) / height;
        // not normalised: t is 1 at the window
        Vec direction = ahead + (x + 0.5 - width / 2) * size * right + (height / 2 - y - 0.5) * size * up;
        pixel = {x, y};
        rays = 0;
        log("pixel_colour", {}, {{"raw", colour(start("eye", cop, direction), 1)}});
    }
};

int main(int count, char** words) {
    Tracer tracer;
    std::ifstream(words[1]) >> tracer.scene;
    for (int i = 2; i < count; i++) tracer.trace(std::stoi(words[i]), std::stoi(std::string(words[i]).substr(std::string(words[i]).find(',') + 1)));
    if (count > 2) return 0;
    int width = tracer.scene["camera"]["pixels"][0], height = tracer.scene["camera"]["pixels"][1];
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) tracer.trace(x, y);
}
