#include "render/stencil/layer_painter.h"

#include <string>

namespace enfilade::stencil {
namespace {

const char* preamble() {
    return epoxy_is_desktop_gl() ? "#version 330 core\n"
                                 : "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                                   "precision highp usampler2D;\n";
}

Error driver_says(const std::string& log) {
    return {"stencil renderer", "the graphics driver refuses a shader: " + log};
}

Result<void> compile(GLuint program, GLenum kind, const std::string& text) {
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

/// parts: what both shaders are to have.
Result<void> link(GlProgram& program, const std::string& parts, const std::string& fragment_shader) {
    program.create();
    if (const Result<void> done = compile(program.id(), GL_VERTEX_SHADER, parts + kVertexShader); !done.ok())
        return done.error();
    if (const Result<void> done = compile(program.id(), GL_FRAGMENT_SHADER, parts + kWallDepth + fragment_shader);
        !done.ok())
        return done.error();
    glLinkProgram(program.id());
    GLint done = 0;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &done);
    if (done != 0) return {};
    char log[1024] = "";
    glGetProgramInfoLog(program.id(), sizeof log, nullptr, log);
    return driver_says(log);
}

GLint uniform(const GlProgram& program, const char* name) { return glGetUniformLocation(program.id(), name); }

std::string part(const std::string& name) { return "#define " + name + "\n"; }

std::string parts_of(Kind kind) {
    constexpr const char* kPaints[] = {"WALLS", "FLATS", "SKIES", "COLORS"};
    std::string parts = part(kPaints[paints(kind)]);
    if (kind & kWithRecords) parts += part("WITH_RECORDS") + part(paints(kind) == kSkies ? "LAYERED_SKY" : "LIT");
    if (kind & kWithLayers) parts += part("LAYERED_FLAT");
    if (kind & (kGoingByTable | kWithLayers)) parts += part("BY_TABLE");
    if (kind & kInSmoothLight) parts += part("SMOOTH");
    if (kind & kInClassicLight) parts += part("CLASSIC");
    if (kind & kWithHoles) parts += part("WITH_HOLES");
    return parts;
}

std::string parts_of(VertexPlacing placing) {
    return placing == VertexPlacing::tilted     ? part("TILTED")
           : placing == VertexPlacing::in_space ? part("IN_SPACE")
                                                : "";
}

LensUniforms lens_uniforms(const GlProgram& program) {
    return {uniform(program, "lens"), uniform(program, "depth_row"), uniform(program, "clip")};
}

}  // namespace

Result<void> build(SurfaceProgram& surface, Kind kind, VertexPlacing placing) {
    if (const Result<void> done = link(surface.program, parts_of(placing) + parts_of(kind), kSurfaceShader); !done.ok())
        return done.error();
    surface.entry = uniform(surface.program, "entry");
    surface.entry_span = uniform(surface.program, "entry_span");
    surface.level = uniform(surface.program, "level");
    surface.climb = uniform(surface.program, "climb");
    surface.is_sky_round = uniform(surface.program, "is_sky_round");
    surface.fog = uniform(surface.program, "fog");
    surface.fog_step = uniform(surface.program, "fog_step");
    surface.least_alpha = uniform(surface.program, "least_alpha");
    surface.texels = uniform(surface.program, "texels");
    surface.records = uniform(surface.program, "records");
    surface.color_numbers = uniform(surface.program, "color_numbers");
    surface.color_table = uniform(surface.program, "color_table");
    surface.lens = lens_uniforms(surface.program);
    return {};
}

Result<void> build(MaskProgram& mask, VertexPlacing placing) {
    if (const Result<void> done = link(mask.program, parts_of(placing), kMaskShader); !done.ok()) return done.error();
    mask.lens = lens_uniforms(mask.program);
    return {};
}

}  // namespace enfilade::stencil
