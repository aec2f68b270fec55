// A long list of whole numbers as a texture, which shaders read exactly: entry n is at (n mod kRow, n / kRow).
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/stencil/gl_object.h"

namespace enfilade::stencil {

class ListTexture {
public:
    static constexpr std::uint32_t kRow = 2048;  ///< entries; OpenGL ES 3.0 promises textures this wide

    /// How many entries this graphics card has room for.
    static std::size_t most() {
        GLint rows = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &rows);
        return static_cast<std::size_t>(rows) * kRow;
    }

    /// Holds the list from now on, made up to whole rows; at most most() entries. stored, format, type: as
    /// glTexImage2D calls what an Entry is.
    template <class Entry>
    void hold(std::vector<Entry>& list, GLint stored, GLenum format, GLenum type) {
        const std::size_t rows = (list.size() + kRow - 1) / kRow;
        list.resize(rows * kRow);
        texture_.create();
        glBindTexture(GL_TEXTURE_2D, texture_.id());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, stored, GLsizei(kRow), static_cast<GLsizei>(rows), 0, format, type, list.data());
    }

    GLuint id() const { return texture_.id(); }

private:
    GlTexture texture_;
};

}  // namespace enfilade::stencil
