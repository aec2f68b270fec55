// Where the keys of a record were written, so that whoever finds one of them wrong can point at it.
#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "base/finding.h"

namespace enfilade {

/// The places of a record's values, and which of them the reader could not make sense of. Empty for a record that was
/// not read from a text. Cost: one allocation for a record that has keys, none for others.
class KeyPlaces {
public:
    /// Makes room for so many notes.
    void reserve(std::size_t count) { notes_.reserve(count); }

    /// The value of `key` is at `place`, and whether the reader found nothing wrong with it.
    /// key : a name from a list of keys, which outlives every record
    void note(std::string_view key, TextPlace place, bool is_sound) {
        notes_.push_back({key, place, is_sound});
        is_sound_ = is_sound_ && is_sound;
    }

    /// Something else is wrong with the record: a key that it has not, or lacks.
    void note_fault() { is_sound_ = false; }

    /// The place of the key's value, or `otherwise` where it is not given.
    TextPlace of(std::string_view key, TextPlace otherwise) const {
        const Note* note = find(key);
        return note ? note->place : otherwise;
    }

    bool has(std::string_view key) const { return find(key) != nullptr; }

    /// The reader had nothing to say about the whole record, or about this key of it: what is wrong now is no
    /// consequence of what it said.
    bool is_sound() const { return is_sound_; }
    bool is_sound(std::string_view key) const {
        const Note* note = find(key);
        return !note || note->is_sound;
    }

    /// Always: records that say the same are equal, wherever they were written.
    bool operator==(const KeyPlaces&) const { return true; }

private:
    struct Note {
        std::string_view key;
        TextPlace place;
        bool is_sound;
    };

    const Note* find(std::string_view key) const {
        const auto it = std::ranges::find(notes_, key, &Note::key);
        return it == notes_.end() ? nullptr : &*it;
    }

    std::vector<Note> notes_;
    bool is_sound_ = true;
};

/// Where the value of one of the record's keys is, or where the record begins if it has none.
template <class Record>
TextPlace key_place(const Record& record, std::string_view key) {
    return record.places.of(key, record.place);
}

}  // namespace enfilade
