#include "render/stencil/shaders.h"

#include <string>

namespace enfilade::stencil {
namespace {

// Nothing is interpolated: a pixel computes what it shows from its own place, as the other renderers do, and every
// value a polygon has is the same in all of its vertices. Rows count from the top because the picture is drawn upside
// down. The depth buffer holds how many rooms one looks through (surfaces.cpp), or of tilted pictures 1 / (1 + metres):
// the nearer the larger, evenly fine in proportion at any distance in a float buffer.

constexpr const char* kVertexShader = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 in_place;
layout(location = 2) in vec3 in_line;
layout(location = 3) in vec4 in_bounds;
layout(location = 4) in vec4 in_a;
layout(location = 5) in vec4 in_b;
layout(location = 6) in vec4 in_c;
layout(location = 7) in uvec4 in_what;
layout(location = 8) in vec3 in_left_edge;
layout(location = 9) in vec3 in_right_edge;
flat out vec4 place;
flat out vec3 line;
flat out vec4 bounds;
flat out vec4 a;
flat out vec4 b;
flat out vec4 c;
flat out uvec4 what;
flat out vec3 left_edge;
flat out vec3 right_edge;
void main() {
    gl_Position = vec4(position, 0.0, 1.0);
    place = in_place;
    line = in_line;
    bounds = in_bounds;
    a = in_a;
    b = in_b;
    c = in_c;
    what = in_what;
    left_edge = in_left_edge;
    right_edge = in_right_edge;
}
)";

constexpr const char* kWallDepth = R"(
flat in vec4 place;   // from x, from y, cross, order
flat in vec3 line;    // span there, per column, per row
flat in vec4 bounds;  // nearest, farthest, light, contrast
flat in vec3 left_edge;
flat in vec3 right_edge;
uniform int is_tilted;
vec2 way() { return gl_FragCoord.xy - place.xy; }
float even(vec3 number, vec2 t) { return number.x + number.y * t.x + number.z * t.y; }
float wall_depth(vec2 t) {
    float s = even(line, t);
    return s > 0.0 ? clamp(place.z / s, bounds.x, bounds.y) : bounds.y;
}
// Between columns the edges of polygons are exact. Tilted there are no columns: each pixel asks the edge functions of
// the wall's ends, which neighbours share.
bool is_beside() {
    return is_tilted != 0 && (even(left_edge, gl_FragCoord.xy) < 0.0 || even(right_edge, gl_FragCoord.xy) >= 0.0);
}
// Which of two walls is nearer the CPU has decided exactly. Tilted it is asked where the ray meets them.
float tested_depth() { return is_tilted == 0 ? place.w : 1.0 / (1.0 + wall_depth(way())); }
)";

constexpr const char* kMaskShader = R"(
uniform int is_far;
void main() {
    if (is_beside()) discard;
    gl_FragDepth = is_far != 0 ? 0.0 : tested_depth();
}
)";

// Light as in render/shade.cpp, sky and texels as in render/shade.h.
constexpr const char* kSurfaceShader = R"(
flat in vec4 a;
flat in vec4 b;
flat in vec4 c;
flat in uvec4 what;  // id, paint and light model, place in the store, size, record
layout(location = 0) out vec4 out_color;
layout(location = 1) out uvec4 out_facts;
uniform vec3 entry;       // the doorway one looks in through: cross, and a point in it [px]; cross 0: none
uniform vec3 entry_span;  // there, per column, per row
uniform vec2 level;  // a point at or near the horizon, so that rows next to it keep their precision
uniform vec3 climb;  // what the ray climbs there, per column, per row
uniform int is_sky_round;
uniform vec4 fog;  // its colour, 0 to 255, and the depth where it hides half; 0: no fog
uniform uint least_alpha;  // that is shown; 0: whatever it is, the picture is opaque
uniform usampler2D texels;

const uint kWall = 0u, kFlat = 1u, kSky = 2u, kPicture = 4u;
const uint kInfinity = 0x7F800000u;

float part(float x) {
    float f = x - floor(x);
    return f < 1.0 ? f : 0.0;
}

// The tie rule for texels (render/shade.h), as far as floats go: they leave a position a few tiles away good to 2^-20
// of a tile, so a step of 2^-18 is about the finest that still gathers what should stand at a texel's edge.
vec2 nearest(vec2 tiles) {
    const float steps = 262144.0;
    return round(tiles * steps) / steps;
}

ivec2 list_place(uint n) { return ivec2(int(n & 2047u), int(n >> 11u)); }

uint texel_place(uvec2 picture, vec2 tile) {  // where it begins, its size
    uvec2 size = uvec2(picture.y & 65535u, picture.y >> 16u);
    uvec2 at = min(uvec2(tile * vec2(size)), size - 1u);
    return picture.x + at.x * size.y + at.y;
}

uvec4 texel_of(uvec2 picture, vec2 tile) { return texelFetch(texels, list_place(texel_place(picture, tile)), 0); }

uvec4 texel(vec2 tile) { return texel_of(what.yz, tile); }

#ifdef WITH_RECORDS
uniform usampler2D records;
uvec2 record(uint n) { return texelFetch(records, list_place(n), 0).xy; }
vec2 numbers(uint n) { return uintBitsToFloat(record(n)); }
#endif

#ifdef BY_TABLE
uniform usampler2D color_numbers;
uniform usampler2D color_table;
#endif

// What is left of a texel's colour in a shade, without lamps (darkened_colors of render/shade.h).
uvec3 darkened(uvec3 color, vec2 tile, uint shade) {
#ifdef BY_TABLE
    if ((what.x >> 30u & 1u) != 0u) {
        uint number = texelFetch(color_numbers, list_place(texel_place(what.yz, tile)), 0).x;
        uint level = min((256u - min(shade, 256u)) / 8u, 31u);
        return texelFetch(color_table, list_place(level * 256u + number), 0).rgb;
    }
#endif
    return color * shade >> 8u;
}

// Round heights and looks put whole pictures on the very edge between two levels of classic light. A depth in 32 bits is
// off by about 2^-22 of itself, at 23 levels by 2^-17 of a level, so a step of 2^-14 gathers what should stand there
// (on_nearest_step() of render/shade.h has finer ones).
float on_level(float levels) {
    return floor(levels * 16384.0 + 0.5) / 16384.0;
}

uint classic_shade(float light, float contrast, float depth) {
    float towards = contrast < 1.0 ? -2.0 : contrast > 1.0 ? 2.0 : 0.0;
    float number = clamp(floor(light * 32.0) + towards, 0.0, 31.0);
    float level = 2.0 * (30.0 - number) - min(floor(on_level(40.0 / max(depth, 0.01))), 23.0);
    return uint((32.0 - clamp(level, 0.0, 31.0)) * 8.0);
}

uint smooth_shade(float light, float contrast, float depth) {
    float nearness = (1.0 - light) * 2.0 / 9.0 * min(depth, 1e9);
    float falloff = 1.0 / (1.0 + nearness * nearness);
    return uint(256.0 * min(light * contrast, 1.0) * falloff + 0.5);
}

uint shade_at(float depth) {
    return (what.x >> 31u) != 0u ? classic_shade(bounds.z, bounds.w, depth) : smooth_shade(bounds.z, bounds.w, depth);
}

uvec3 in_fog(uvec3 color, float depth) {
    float part = min(depth, 1e9) / fog.w;
    uint mist = uint(256.0 * (1.0 - 1.0 / (1.0 + part * part)) + 0.5);
    return color * (256u - mist) + uvec3(fog.rgb) * mist >> 8u;
}

// Edges between rows are up to kTieShift aside, which is at most 1/128 of the distance: a flat that so begins before
// the doorway it is seen through, or ends behind the wall it ends at, shows what is just inside instead. What is farther
// outside belongs to flats that are drawn where they are not (flat_look).
float flat_depth(float height, float up, float met) {
    const float shift = 0.0078125;
    const float just_inside = 3.0517578125e-05;  // half a step of texels, a quarter of a tile away
    if (up == 0.0) return met;
    float there = height / up;
    float s = even(entry_span, gl_FragCoord.xy - entry.yz);
    float begin = entry.x > 0.0 && s > 0.0 ? entry.x / s : 0.0;
    if (there < begin && there > begin * (1.0 - shift)) there = begin * (1.0 + just_inside);
    if (there > met && there < met * (1.0 + shift)) there = met * (1.0 - just_inside);
    return clamp(there, 0.0, met);
}

vec2 sky_tile(float turns, float elevation, vec2 tile, vec2 offset) {
    vec2 spot = nearest(vec2(turns * tile.x - offset.x, clamp(1.0 - elevation / tile.y - offset.y, 0.0, 1.0)));
    return vec2(part(spot.x), spot.y);
}

#ifdef LAYERED_SKY
uvec4 with_layers(uvec4 color, float turns, float elevation) {
    uint count = record(what.w).x;
    for (uint i = 0u; i < count; ++i) {
        uint n = what.w + 1u + 3u * i;
        uvec4 over = texel_of(record(n), sky_tile(turns, elevation, numbers(n + 1u), numbers(n + 2u)));
        color.rgb = (over.rgb * over.a + color.rgb * (255u - over.a) + 127u) / 255u;
    }
    return color;
}
#endif

#ifdef LIT
// Positions count the points of the grid, by column.
uvec3 glow_at(vec2 known) {
    if (what.w == 0u) return uvec3(0u);
    uvec2 place = record(what.w);
    uvec2 count = uvec2(place.y & 65535u, place.y >> 16u);
    vec2 at = clamp(numbers(what.w + 1u) * known + numbers(what.w + 2u), vec2(0.0), vec2(count - 1u));
    uvec2 cell = min(uvec2(at), count - 2u);
    uvec2 part = uvec2((at - vec2(cell)) * 256.0);
    uint n = place.x + cell.x * count.y + cell.y;
    uvec2 left = record(n), right = record(n + count.y), left_up = record(n + 1u), right_up = record(n + count.y + 1u);
    uvec3 low = uvec3(left.x & 65535u, left.x >> 16u, left.y) * (256u - part.x) +
                uvec3(right.x & 65535u, right.x >> 16u, right.y) * part.x >> 8u;
    uvec3 high = uvec3(left_up.x & 65535u, left_up.x >> 16u, left_up.y) * (256u - part.x) +
                 uvec3(right_up.x & 65535u, right_up.x >> 16u, right_up.y) * part.x >> 8u;
    return (low * (256u - part.y) + high * part.y >> 8u) / 16u;
}

uvec3 lit_by(uvec3 glow, uvec3 color, vec2 tile, uint shade) {
    bool is_by_table = (what.x >> 30u & 1u) != 0u;
    if (!is_by_table) return min(color * min(glow + shade, 512u) >> 8u, 255u);
    return min(darkened(color, tile, shade) + (color * min(glow, 512u - shade) >> 8u), 255u);
}
#endif

void main() {
    if (is_beside()) discard;
    vec2 t = way();
    float up = even(climb, gl_FragCoord.xy - level);
    float met = wall_depth(t), depth = met;
    uint paint = what.x >> 24u & 63u;
    uint shade = 256u;
    vec2 tile = vec2(0.0), known = vec2(0.0);
    uvec4 color;
    if (paint == kWall || paint == kPicture) {
        float along = clamp(even(a.xyz, t) / max(even(line.xyz, t), 1e-30), 0.0, 1.0);
        float v = b.y - up * met * b.z;
        tile = nearest(vec2(along * a.w - b.x, v));
        tile = vec2(part(tile.x), paint == kWall ? part(tile.y) : clamp(tile.y, 0.0, 1.0));  // a picture is shown once
        shade = shade_at(depth);
        color = texel(tile);
        known = vec2(along, up * met);
    } else if (paint == kFlat) {
        depth = flat_depth(c.z, up, met);
        known = depth * vec2(even(a.xyz, t), even(b.xyz, t));
        vec2 spot = nearest(c.xy + known);
        tile = vec2(part(spot.x), part(spot.y));
        shade = shade_at(depth);
        color = texel(tile);
    } else if (paint == kSky) {
        vec2 ahead = vec2(even(a.xyz, t), even(b.xyz, t));
        float turns = part(atan(ahead.y, ahead.x) * 0.15915494309189535);
        float elevation = is_sky_round != 0 ? up / length(ahead) : up;
        tile = sky_tile(turns, elevation, c.xy, c.zw);
        color = texel(tile);
#ifdef LAYERED_SKY
        color = with_layers(color, turns, elevation);
#endif
    } else {
        color = uvec4(what.y & 255u, what.y >> 8u & 255u, what.y >> 16u & 255u, 255u);
    }
    if (color.a < least_alpha) discard;
    uint alpha = least_alpha > 0u ? color.a : 255u;
#ifdef LIT
    uvec3 lit = lit_by(glow_at(known), color.rgb, tile, shade);
#else
    uvec3 lit = darkened(color.rgb, tile, shade);
#endif
    bool is_lit = paint == kWall || paint == kPicture || paint == kFlat;
    if (fog.w > 0.0 && is_lit) lit = in_fog(lit, depth);
    out_color = vec4(uvec4(lit, alpha)) / 255.0;
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

GLint uniform(const GlProgram& program, const char* name) { return glGetUniformLocation(program.id(), name); }

const char* parts_of(Kind kind) {
    switch (kind) {
        case Kind::plain: return "";
        case Kind::layered_sky: return "#define WITH_RECORDS\n#define LAYERED_SKY\n";
        case Kind::lit: return "#define WITH_RECORDS\n#define LIT\n";
        case Kind::by_table: return "#define BY_TABLE\n";
        case Kind::lit_by_table: return "#define WITH_RECORDS\n#define LIT\n#define BY_TABLE\n";
    }
    return "";
}

}  // namespace

Status build(SurfaceProgram& surface, Kind kind) {
    if (Status failed = link(surface.program, std::string(parts_of(kind)) + kWallDepth + kSurfaceShader)) return failed;
    surface.is_tilted = uniform(surface.program, "is_tilted");
    surface.entry = uniform(surface.program, "entry");
    surface.entry_span = uniform(surface.program, "entry_span");
    surface.level = uniform(surface.program, "level");
    surface.climb = uniform(surface.program, "climb");
    surface.is_sky_round = uniform(surface.program, "is_sky_round");
    surface.fog = uniform(surface.program, "fog");
    surface.least_alpha = uniform(surface.program, "least_alpha");
    surface.texels = uniform(surface.program, "texels");
    surface.records = uniform(surface.program, "records");
    surface.color_numbers = uniform(surface.program, "color_numbers");
    surface.color_table = uniform(surface.program, "color_table");
    return {};
}

Status build(MaskProgram& mask) {
    if (Status failed = link(mask.program, std::string(kWallDepth) + kMaskShader)) return failed;
    mask.is_tilted = uniform(mask.program, "is_tilted");
    mask.is_far = uniform(mask.program, "is_far");
    return {};
}

}  // namespace enfilade::stencil
