// Which pictures follow which, and which are the two faces of a switch.
#include "formats/quoted.h"
#include "map/draft.h"

namespace enfilade {
namespace {

void note_animation(Draft& draft, const AnimationRecord& record) {
    PictureChanges& pictures = draft.map.pictures;
    Animation animation{{}, record.seconds};
    for (const std::string& frame : record.frames)
        if (const TextureId id = draft.textures.find(frame)) animation.frames.push_back(id);
    if (animation.frames.empty()) return;
    const auto number = static_cast<std::uint32_t>(pictures.animations.size());
    for (const TextureId id : animation.frames) {
        std::uint32_t& owner = pictures.animation_of[id.index];
        if (owner != PictureChanges::kNone && owner != number)
            draft.error(record, "frames", "animated-twice",
                        "the picture " + quoted(draft.textures[id].name) +
                            " belongs to another animation already; a picture can only be in one");
        owner = number;
    }
    pictures.animations.push_back(std::move(animation));
}

void note_switch(Draft& draft, const SwitchRecord& record) {
    const TextureId off = draft.textures.find(record.off), on = draft.textures.find(record.on);
    if (!off || !on) return;
    draft.map.pictures.other_face[off.index] = on;
    draft.map.pictures.other_face[on.index] = off;
}

}  // namespace

void note_picture_changes(Draft& draft) {
    PictureChanges& pictures = draft.map.pictures;
    const std::size_t count = draft.textures.textures.size();
    if (!draft.file.animations.empty()) pictures.animation_of.assign(count, PictureChanges::kNone);
    if (!draft.file.switches.empty()) pictures.other_face.assign(count, TextureId());
    for (const AnimationRecord& record : draft.file.animations) note_animation(draft, record);
    for (const SwitchRecord& record : draft.file.switches) note_switch(draft, record);
}

}  // namespace enfilade
