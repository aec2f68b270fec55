#include "figure.h"

namespace draw_textures {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kSteps = 90;        // of a ray towards the body
constexpr double kNear = 0.0008;  // as good as there, in metres
constexpr double kDistance = 2;   // from where one looks, in metres
constexpr double kTiny = 0.003;   // between the points that tell which way a face looks

double length(Vec3 v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vec3 normal_at(const Body& body, Vec3 p) {
    const auto slope = [&](Vec3 step) { return body(p + step).distance - body(p - step).distance; };
    const Vec3 n{slope({kTiny, 0, 0}), slope({0, kTiny, 0}), slope({0, 0, kTiny})};
    return n * (1 / std::max(length(n), 1e-9));
}

// Which way one looks: towards the viewer, and to the right on the picture.
struct Side {
    Vec3 to_viewer, right;
};

Side side_of(int view) {
    const double turn = view * kPi / 4;
    return {{std::cos(turn), std::sin(turn), 0}, {-std::sin(turn), std::cos(turn), 0}};
}

// Light from above, on the viewer's left, and a little from everywhere.
Color lit(const Matter& matter, Vec3 normal, const Side& side) {
    const Vec3 light = side.to_viewer * 0.55 + side.right * -0.45 + Vec3{0, 0, 0.7};
    const double facing = std::max(0.0, dot(normal, light)), rim = 1 - std::max(0.0, dot(normal, side.to_viewer));
    const double brightness = 0.38 + 0.75 * facing - 0.18 * rim;
    return matter.color * (matter.glow + (1 - matter.glow) * brightness);
}

}  // namespace

double ball(Vec3 p, Vec3 middle, double radius) { return length(p - middle) - radius; }

double stick(Vec3 p, Vec3 a, Vec3 b, double radius) {
    const Vec3 along = b - a, to = p - a;
    return length(to - along * clamp01(dot(to, along) / dot(along, along))) - radius;
}

double cone(Vec3 p, double foot, double top, double foot_radius, double top_radius) {
    const double t = clamp01((p.z - foot) / (top - foot));
    const double out = std::hypot(p.x, p.y) - (foot_radius + t * (top_radius - foot_radius));
    const double beyond = std::max(foot - p.z, p.z - top);
    return std::max(0.8 * out, beyond);
}

double box(Vec3 p, Vec3 middle, Vec3 half) {
    return std::max(
        {std::abs(p.x - middle.x) - half.x, std::abs(p.y - middle.y) - half.y, std::abs(p.z - middle.z) - half.z});
}

Painter figure(const Body& body, int view, int width, int height, double size, double below) {
    const Side side = side_of(view);
    return [=](double x, double y, double, double) -> Surface {
        const double across = (x - width / 2.0) / size, up = (height - below - y) / size;
        double depth = kDistance;
        for (int i = 0; i < kSteps && depth > -kDistance; ++i) {
            const Vec3 p = side.right * across + side.to_viewer * depth + Vec3{0, 0, up};
            const Matter matter = body(p);
            if (matter.distance < kNear) return {lit(matter, normal_at(body, p), side), 0, 1};
            depth -= matter.distance * 0.8;
        }
        return {{0, 0, 0}, 0, 0};
    };
}

}  // namespace draw_textures
