#include "platform/gl_screen.h"

#include <epoxy/gl.h>

#include <string>

namespace enfilade {
namespace {

/// Two triangles over the whole area; row 0 of a picture is at its top.
constexpr const char* kCorners = R"(
out vec2 place;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    place = vec2(corner.x, 1.0 - corner.y);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
})";

constexpr const char* kColors = R"(
in vec2 place;
out vec4 color;
uniform sampler2D picture, over;
uniform float power;
uniform bool with_over;
void main() {
    vec3 light = texture(picture, place).rgb;
    if (power != 1.0) light = pow(light, vec3(power));
    vec4 front = with_over ? texture(over, place) : vec4(0.0);
    color = vec4(front.rgb + light * (1.0 - front.a), 1.0);
})";

std::string beginning() {
    return epoxy_is_desktop_gl() ? "#version 330 core\n" : "#version 300 es\nprecision highp float;\n";
}

Result<void> add_shader(GLuint program, GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint is_compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
    std::string said(1024, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(said.size()), &length, said.data());
    glAttachShader(program, shader);
    glDeleteShader(shader);
    if (is_compiled == GL_TRUE) return {};
    return Error{"window", "the graphics card's driver refuses a program: " + said.substr(0, std::size_t(length))};
}

}  // namespace

Result<void> GlScreen::prepare() {
    program_.create();
    if (const Result<void> done = add_shader(program_.id(), GL_VERTEX_SHADER, beginning() + kCorners); !done.ok())
        return done.error();
    if (const Result<void> done = add_shader(program_.id(), GL_FRAGMENT_SHADER, beginning() + kColors); !done.ok())
        return done.error();
    glLinkProgram(program_.id());
    GLint is_linked = GL_FALSE;
    glGetProgramiv(program_.id(), GL_LINK_STATUS, &is_linked);
    if (is_linked != GL_TRUE) return Error{"window", "the graphics card's driver cannot link a program"};
    no_vertices_.create();
    copy_.create();
    glUseProgram(program_.id());
    glUniform1i(glGetUniformLocation(program_.id(), "over"), 1);
    brightness_at_ = glGetUniformLocation(program_.id(), "power");
    with_over_at_ = glGetUniformLocation(program_.id(), "with_over");
    return {};
}

void GlScreen::CardTexture::resize(int new_width, int new_height) {
    texture.create();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    if (width == new_width && height == new_height) return;
    width = new_width;
    height = new_height;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
}

void GlScreen::CardTexture::upload(const Frame& frame) {
    resize(frame.width, frame.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, frame.pixels.data());
}

Result<void> GlScreen::show(const Frame& frame, const PictureArea& area) {
    glActiveTexture(GL_TEXTURE0);
    picture_.upload(frame);
    return draw(false, 1, area);
}

Result<void> GlScreen::show(const GlPicture& picture, const Frame& over, double brightness, const PictureArea& area) {
    glActiveTexture(GL_TEXTURE0);
    picture_.resize(picture.width, picture.height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, copy_.id());
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_.texture.id(), 0);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, picture.width, picture.height, 0, 0, picture.width, picture.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glActiveTexture(GL_TEXTURE1);
    over_.upload(over);
    return draw(true, brightness, area);
}

/// What the picture's renderer left switched on is switched off; it sets all it needs itself.
Result<void> GlScreen::draw(bool with_over, double brightness, const PictureArea& area) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    for (const GLenum what : {GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_BLEND, GL_CULL_FACE}) glDisable(what);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(0, 0, 0, 1);
    glViewport(0, 0, area.window_width, area.window_height);
    glClear(GL_COLOR_BUFFER_BIT);
    glViewport(area.left, area.window_height - area.top - area.height, area.width, area.height);
    glUseProgram(program_.id());
    glUniform1f(brightness_at_, static_cast<float>(1 / brightness));
    glUniform1i(with_over_at_, with_over ? 1 : 0);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        return Error{"window", "OpenGL reports error " + std::to_string(error) + " where the picture is shown"};
    return {};
}

}  // namespace enfilade
