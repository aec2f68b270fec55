// OpenGL's objects with an owner, so that none is left behind. All calls with the context they belong to current.
#pragma once
#include <epoxy/gl.h>

#include <utility>

namespace enfilade::stencil {

/// One name of the kind that Make creates and Drop deletes; 0: none yet.
template <auto Make, auto Drop>
class GlObject {
public:
    GlObject() = default;
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;
    ~GlObject() {
        if (id_ != 0) Drop(id_);
    }

    /// Makes it where that was not done before.
    void create() {
        if (id_ == 0) id_ = Make();
    }
    GLuint id() const { return id_; }

private:
    GLuint id_ = 0;
};

namespace detail {
// epoxy's functions are variables that find the driver's at their first call, so they need wrapping.
inline GLuint make_texture() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
}
inline void drop_texture(GLuint id) { glDeleteTextures(1, &id); }
inline GLuint make_buffer() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
}
inline void drop_buffer(GLuint id) { glDeleteBuffers(1, &id); }
inline GLuint make_vertex_array() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
}
inline void drop_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
inline GLuint make_framebuffer() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
}
inline void drop_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline GLuint make_renderbuffer() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return id;
}
inline void drop_renderbuffer(GLuint id) { glDeleteRenderbuffers(1, &id); }
inline GLuint make_program() { return glCreateProgram(); }
inline void drop_program(GLuint id) { glDeleteProgram(id); }
}  // namespace detail

using GlTexture = GlObject<detail::make_texture, detail::drop_texture>;
using GlBuffer = GlObject<detail::make_buffer, detail::drop_buffer>;
using GlVertexArray = GlObject<detail::make_vertex_array, detail::drop_vertex_array>;
using GlFramebuffer = GlObject<detail::make_framebuffer, detail::drop_framebuffer>;
using GlRenderbuffer = GlObject<detail::make_renderbuffer, detail::drop_renderbuffer>;
using GlProgram = GlObject<detail::make_program, detail::drop_program>;

}  // namespace enfilade::stencil
