#include "render/stencil/layer_painter.h"

namespace enfilade::stencil {

// Nothing is interpolated: a pixel computes what it shows from its own place, as the other renderers do, and every
// value a polygon has is the same in all of its vertices. Rows count from the top because the picture is drawn upside
// down. The depth buffer holds no depths, but ranks that the CPU has decided exactly (surfaces.cpp).

const char* const kVertexShader = R"(
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
#ifdef IN_SPACE
uniform vec4 lens;       // per right, per ahead of the columns, per up, per ahead of the rows
uniform vec4 depth_row;  // of right, up, ahead and 1: as clip, of which what is positive is kept
uniform vec4 clip;
void place_vertex() {
    vec4 point = vec4(position, in_place.w, 1.0);
    gl_Position = vec4(point.x * lens.x + point.z * lens.y, point.y * lens.z + point.z * lens.w, dot(depth_row, point), point.z);
    gl_ClipDistance[0] = dot(clip, point);
}
#else
void place_vertex() {
    gl_Position = vec4(position, 2.0 * in_place.w - 1.0, 1.0);  // exact, and the same all over the polygon
}
#endif
void main() {
    place_vertex();
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

const char* const kWallDepth = R"(
flat in vec4 place;   // from x, from y, cross, order
flat in vec3 line;    // span there, per column, per row
flat in vec4 bounds;  // nearest, farthest, light, contrast
flat in vec3 left_edge;
flat in vec3 right_edge;
vec2 way() { return gl_FragCoord.xy - place.xy; }
float even(vec3 number, vec2 t) { return number.x + number.y * t.x + number.z * t.y; }
float wall_depth(vec2 t) {
    float s = even(line, t);
    return s > 0.0 ? clamp(place.z / s, bounds.x, bounds.y) : bounds.y;
}
#ifdef TILTED
// Tilted there are no columns, between which the edges of polygons are exact: each pixel asks the edge functions of the
// wall's ends, which neighbours share.
bool is_beside() { return even(left_edge, gl_FragCoord.xy) < 0.0 || even(right_edge, gl_FragCoord.xy) >= 0.0; }
#endif
)";

const char* const kMaskShader = R"(
void main() {
#ifdef TILTED
    if (is_beside()) discard;
#endif
}
)";

// Light as in render/lighting.cpp, sky and texels as in render/shade.h.
const char* const kSurfaceShader = R"(
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
uniform uint fog_step;  // by which it grows, in 256ths
#ifdef WITH_HOLES
uniform uint least_alpha;  // that is shown
#endif
uniform usampler2D texels;

const uint kPicture = 4u;
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

struct SampledPicture {
    uvec2 place;  // where it begins in the store, its size
    bool is_by_table;
};
SampledPicture own_picture() { return SampledPicture(what.yz, (what.x >> 30u & 1u) != 0u); }

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
uvec3 darkened(uvec3 color, SampledPicture picture, vec2 tile, uint shade) {
#ifdef BY_TABLE
    if (picture.is_by_table) {
        uint number = texelFetch(color_numbers, list_place(texel_place(picture.place, tile)), 0).x;
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
#if defined CLASSIC && defined SMOOTH
    return (what.x >> 31u) != 0u ? classic_shade(bounds.z, bounds.w, depth) : smooth_shade(bounds.z, bounds.w, depth);
#elif defined CLASSIC
    return classic_shade(bounds.z, bounds.w, depth);
#else
    return smooth_shade(bounds.z, bounds.w, depth);
#endif
}

uvec3 in_fog(uvec3 color, float depth) {
    float part = min(depth, 1e9) / fog.w;
    uint fog_part = uint(256.0 * (1.0 - 1.0 / (1.0 + part * part)) + 0.5);
    fog_part = (fog_part + fog_step / 2u) / fog_step * fog_step;
    return color * (256u - fog_part) + uvec3(fog.rgb) * fog_part >> 8u;
}

// Edges between rows are up to kTieShift aside, which is at most 1/128 of the distance: a flat that so begins before
// the doorway it is seen through, or ends behind the wall it ends at, shows what is just inside instead. What is farther
// outside belongs to flats that are drawn where they are not (flat_params).
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
    float down = max(1.0 - elevation / tile.y - offset.y, 0.0);
    vec2 spot = nearest(vec2(turns * tile.x - offset.x, is_sky_round != 0 ? min(down, 1.0) : down));
    return vec2(part(spot.x), is_sky_round != 0 ? spot.y : part(spot.y));
}

uvec3 laid_over(uvec3 below, uvec4 above) {
    return (above.rgb * above.a + below * (255u - above.a) + 127u) / 255u;
}

#ifdef LAYERED_SKY
uvec4 with_layers(uvec4 color, float turns, float elevation) {
    uint count = record(what.w).x;
    for (uint i = 0u; i < count; ++i) {
        uint n = what.w + 1u + 3u * i;
        uvec4 over = texel_of(record(n), sky_tile(turns, elevation, numbers(n + 1u), numbers(n + 2u)));
        color.rgb = laid_over(color.rgb, over);
    }
    return color;
}
#endif

#ifdef LIT
uint glow_record() {
#ifdef LAYERED_FLAT
    return record(what.w).y;
#else
    return what.w;
#endif
}

ivec3 channels_of(uvec2 light) { return ivec3(light.x & 65535u, light.x >> 16u, light.y); }

// As between() of render/shade.h.
ivec3 between(ivec3 a, ivec3 b, int part) { return a + ((b - a) * part + 16384 >> 15); }

// Positions count the points of the grid, by column.
uvec3 lamplight_at(vec2 known) {
    uint own = glow_record();
    if (own == 0u) return uvec3(0u);
    uvec2 place = record(own);
    uvec2 count = uvec2(place.y & 65535u, place.y >> 16u);
    vec2 at = clamp(numbers(own + 1u) * known + numbers(own + 2u), vec2(0.0), vec2(count - 1u));
    uvec2 cell = min(uvec2(at), count - 2u);
    ivec2 part = min(ivec2((at - vec2(cell)) * 32768.0), ivec2(32767));
    uint n = place.x + cell.x * count.y + cell.y;
    ivec3 low = between(channels_of(record(n)), channels_of(record(n + count.y)), part.x);
    ivec3 high = between(channels_of(record(n + 1u)), channels_of(record(n + count.y + 1u)), part.x);
    return uvec3(between(low, high, part.y)) / 16u;
}

uvec3 lit_by(uvec3 lamplight, uvec3 color, SampledPicture picture, vec2 tile, uint shade) {
    if (!picture.is_by_table) return min(color * min(lamplight + shade, 512u) >> 8u, 255u);
    return min(darkened(color, picture, tile, shade) + (color * min(lamplight, 512u - shade) >> 8u), 255u);
}
#endif

#ifdef LAYERED_FLAT
// known: tiles of the flat's own picture from where the eye is.
uvec3 with_layers(uvec3 color, vec2 known, uvec3 lamplight, uint shade) {
    uint count = record(what.w).x;
    for (uint i = 0u; i < count; ++i) {
        uint n = what.w + 1u + 4u * i;
        SampledPicture picture = SampledPicture(record(n), record(n + 3u).x != 0u);
        vec2 spot = nearest(known * numbers(n + 1u) + numbers(n + 2u));
        vec2 tile = vec2(part(spot.x), part(spot.y));
        uvec4 over = texel_of(picture.place, tile);
        color = laid_over(color, uvec4(lit_by(lamplight, over.rgb, picture, tile, shade), over.a));
    }
    return color;
}
#endif

// What a pixel shows, before it is lit.
struct Look {
    uvec4 color;
    float depth;
    uint shade;
    vec2 tile, known;  // where on its picture; what lamps and layers are told of the place
};

// t: way(). up: what the pixel's ray climbs. met: the depth at which it meets the wall.
#if defined WALLS
Look look_at(vec2 t, float up, float met) {
    float along = clamp(even(a.xyz, t) / max(even(line.xyz, t), 1e-30), c.x, c.y);  // from the part that is known
    float v = b.y - up * met * b.z;
    vec2 spot = nearest(vec2(along * a.w - b.x, v));
    bool is_once = (what.x >> 24u & 7u) == kPicture;  // a picture is shown once
    vec2 tile = vec2(part(spot.x), is_once ? clamp(spot.y, 0.0, 1.0) : part(spot.y));
    return Look(texel(tile), met, shade_at(met), tile, vec2(along - c.x, up * met));
}
#elif defined FLATS
Look look_at(vec2 t, float up, float met) {
    float depth = flat_depth(c.z, up, met);
    vec2 known = depth * vec2(even(a.xyz, t), even(b.xyz, t));
    vec2 spot = nearest(c.xy + known);
    vec2 tile = vec2(part(spot.x), part(spot.y));
    return Look(texel(tile), depth, shade_at(depth), tile, known);
}
#elif defined SKIES
Look look_at(vec2 t, float up, float met) {
    vec2 ahead = vec2(even(a.xyz, t), even(b.xyz, t));
    float turns = part(atan(ahead.y, ahead.x) * 0.15915494309189535);
    float elevation = is_sky_round != 0 ? up / length(ahead) : up;
    vec2 tile = sky_tile(turns, elevation, c.xy, c.zw);
    uvec4 color = texel(tile);
#ifdef LAYERED_SKY
    color = with_layers(color, turns, elevation);
#endif
    return Look(color, met, 256u, tile, vec2(0.0));
}
#else
Look look_at(vec2 t, float up, float met) {
    uvec4 color = uvec4(what.y & 255u, what.y >> 8u & 255u, what.y >> 16u & 255u, 255u);
    return Look(color, met, 256u, vec2(0.0), vec2(0.0));
}
#endif

// Its colour in the light of its room and of lamps, under layers and in fog.
uvec3 lit(Look look) {
#ifdef LIT
    uvec3 lamplight = lamplight_at(look.known);
    uvec3 color = lit_by(lamplight, look.color.rgb, own_picture(), look.tile, look.shade);
#else
    uvec3 color = darkened(look.color.rgb, own_picture(), look.tile, look.shade);
#endif
#ifdef LAYERED_FLAT
    color = with_layers(color, look.known, lamplight, look.shade);
#endif
#if defined WALLS || defined FLATS
    if (fog.w > 0.0) color = in_fog(color, look.depth);
#endif
    return color;
}

void main() {
#ifdef TILTED
    if (is_beside()) discard;
#endif
    vec2 t = way();
    Look look = look_at(t, even(climb, gl_FragCoord.xy - level), wall_depth(t));
#ifdef WITH_HOLES
    if (look.color.a < least_alpha) discard;
    uint alpha = look.color.a;
#else
    uint alpha = 255u;
#endif
    out_color = vec4(uvec4(lit(look), alpha)) / 255.0;
#ifdef SKIES
    uint depth_bits = kInfinity;
#else
    uint depth_bits = floatBitsToUint(look.depth);
#endif
    out_facts = uvec4(what.x & 0xFFFFFFu, depth_bits, floatBitsToUint(look.tile.x), floatBitsToUint(look.tile.y));
}
)";

}  // namespace enfilade::stencil
