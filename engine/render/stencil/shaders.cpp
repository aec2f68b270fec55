#include "render/stencil/shaders.h"

#include <string>

namespace enfilade::stencil {
namespace {

// Nothing is interpolated: a pixel computes what it shows from its own place, as the other renderers do, and every
// value a polygon has is the same in all of its vertices. Rows count from the top because the picture is drawn upside
// down. Depth is 1 / (1 + metres): the nearer the larger, evenly fine in proportion at any distance in a float buffer.

constexpr const char* kVertexShader = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 in_line;
layout(location = 2) in vec4 in_bounds;
layout(location = 3) in vec4 in_a;
layout(location = 4) in vec4 in_b;
layout(location = 5) in uvec4 in_what;
flat out vec4 line;
flat out vec4 bounds;
flat out vec4 a;
flat out vec4 b;
flat out uvec4 what;
void main() {
    gl_Position = vec4(position, 0.0, 1.0);
    line = in_line;
    bounds = in_bounds;
    a = in_a;
    b = in_b;
    what = in_what;
}
)";

constexpr const char* kWallDepth = R"(
flat in vec4 line;    // from_px, cross, span at from_px, span per column
flat in vec4 bounds;  // nearest, farthest, light, contrast
uniform vec4 normal;  // of the ray through column 0 and its change per column, both x, y
float column() { return gl_FragCoord.x - line.x; }
float span(float t) { return line.z + line.w * t; }
float wall_depth(float t) {
    float s = span(t);
    return s > 0.0 ? clamp(line.y / s, bounds.x, bounds.y) : bounds.y;
}
// Which wall is nearer is asked where the tie rule moves the ray to: as far aside as edges are drawn the other way.
float tested_depth() {
    vec2 n = normal.xy + normal.zw * gl_FragCoord.x;
    bool runs_right = n.x != 0.0 ? n.x < 0.0 : n.y < 0.0;
    return 1.0 / (1.0 + wall_depth(column() + (runs_right ? 0.00390625 : -0.00390625)));
}
)";

constexpr const char* kMaskShader = R"(
uniform int is_far;
void main() { gl_FragDepth = is_far != 0 ? 0.0 : tested_depth(); }
)";

// Light as in render/shade.cpp, sky and texels as in render/shade.h.
constexpr const char* kSurfaceShader = R"(
flat in vec4 a;
flat in vec4 b;
flat in uvec4 what;  // id and paint, place in the store, width, height
layout(location = 0) out vec4 out_color;
layout(location = 1) out uvec4 out_facts;
uniform vec2 horizon;
uniform float per_focal;
uniform int is_classic;
uniform uint least_alpha;
uniform usampler2D texels;

const uint kWall = 0u, kFlat = 1u, kSky = 2u, kPicture = 4u;
const float kBelowOne = 0.99999994;
const uint kInfinity = 0x7F800000u;

float part(float x) {
    float f = x - floor(x);
    return f < 1.0 ? f : 0.0;
}

uvec4 texel(vec2 tile) {
    uvec2 size = what.zw;
    uvec2 at = min(uvec2(tile * vec2(size)), size - 1u);
    uint n = what.y + at.x * size.y + at.y;
    return texelFetch(texels, ivec2(int(n & 2047u), int(n >> 11u)), 0);
}

uint classic_shade(float light, float contrast, float depth) {
    float towards = contrast < 1.0 ? -2.0 : contrast > 1.0 ? 2.0 : 0.0;
    float number = clamp(floor(light * 32.0) + towards, 0.0, 31.0);
    float level = 2.0 * (30.0 - number) - min(floor(40.0 / max(depth, 0.01)), 23.0);
    return uint((32.0 - clamp(level, 0.0, 31.0)) * 8.0);
}

uint smooth_shade(float light, float contrast, float depth) {
    float nearness = (1.0 - light) * 2.0 / 9.0 * min(depth, 1e9);
    float falloff = 1.0 / (1.0 + nearness * nearness);
    return uint(256.0 * min(light * contrast, 1.0) * falloff + 0.5);
}

uint shade_at(float depth) {
    return is_classic != 0 ? classic_shade(bounds.z, bounds.w, depth) : smooth_shade(bounds.z, bounds.w, depth);
}

void main() {
    // Above the horizon positive; whole and fractional part apart, so that rows next to it keep their precision.
    float climb = (horizon.x - gl_FragCoord.y + horizon.y) * per_focal;
    float met = wall_depth(column()), depth = met;
    uint paint = what.x >> 24u;
    uint shade = 256u;
    vec2 tile = vec2(0.0);
    uvec4 color;
    if (paint == kWall || paint == kPicture) {
        float along = clamp((a.x + a.y * column()) / max(span(column()), 1e-30), 0.0, kBelowOne);
        float v = b.x - climb * met * b.y;
        tile = vec2(part(along * a.z - a.w), part(paint == kWall ? v : max(v, 0.0)));  // nothing is above a picture
        shade = shade_at(depth);
        color = texel(tile);
    } else if (paint == kFlat) {
        depth = climb == 0.0 ? met : clamp(b.z / climb, 0.0, met);
        vec2 place = b.xy + depth * (a.xy + a.zw * column());
        tile = vec2(part(place.x), part(place.y));
        shade = shade_at(depth);
        color = texel(tile);
    } else if (paint == kSky) {
        vec2 way = a.xy + a.zw * column();
        float turns = part(atan(way.y, way.x) * 0.15915494309189535);
        tile = vec2(part(turns * b.x - b.z), clamp(1.0 - climb / length(way) / b.y - b.w, 0.0, 1.0));
        color = texel(tile);
    } else {
        color = uvec4(what.y & 255u, what.y >> 8u & 255u, what.y >> 16u & 255u, 255u);
    }
    if (color.a < least_alpha) discard;
    uint alpha = least_alpha > 0u ? color.a : 255u;
    out_color = vec4(uvec4(color.rgb * shade >> 8u, alpha)) / 255.0;
    uint depth_bits = paint == kSky ? kInfinity : floatBitsToUint(depth);
    out_facts = uvec4(what.x & 0xFFFFFFu, depth_bits, floatBitsToUint(tile.x), floatBitsToUint(tile.y));
    gl_FragDepth = tested_depth();
}
)";

const char* preamble() {
    return epoxy_is_desktop_gl() ? "#version 330 core\n"
                                 : "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                                   "precision highp usampler2D;\n";
}

Error driver_says(const std::string& log) {
    return {"stencil renderer", "the graphics driver refuses a shader: " + log};
}

Status compile(GLuint program, GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const std::string whole = preamble() + text;
    const char* source = whole.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);  // it lives as long as the program
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done != 0) return {};
    char log[1024] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    return driver_says(log);
}

Status link(GlProgram& program, const std::string& fragment_shader) {
    program.create();
    if (Status failed = compile(program.id(), GL_VERTEX_SHADER, kVertexShader)) return failed;
    if (Status failed = compile(program.id(), GL_FRAGMENT_SHADER, fragment_shader)) return failed;
    glLinkProgram(program.id());
    GLint done = 0;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &done);
    if (done != 0) return {};
    char log[1024] = "";
    glGetProgramInfoLog(program.id(), sizeof log, nullptr, log);
    return driver_says(log);
}

}  // namespace

Status build(SurfaceProgram& surface, MaskProgram& mask) {
    if (Status failed = link(surface.program, std::string(kWallDepth) + kSurfaceShader)) return failed;
    if (Status failed = link(mask.program, std::string(kWallDepth) + kMaskShader)) return failed;
    const auto uniform = [](const GlProgram& program, const char* name) {
        return glGetUniformLocation(program.id(), name);
    };
    surface.normal = uniform(surface.program, "normal");
    surface.horizon = uniform(surface.program, "horizon");
    surface.per_focal = uniform(surface.program, "per_focal");
    surface.is_classic = uniform(surface.program, "is_classic");
    surface.least_alpha = uniform(surface.program, "least_alpha");
    surface.texels = uniform(surface.program, "texels");
    mask.normal = uniform(mask.program, "normal");
    mask.is_far = uniform(mask.program, "is_far");
    return {};
}

}  // namespace enfilade::stencil
