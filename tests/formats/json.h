// Just enough JSON to look at a schema.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace enfilade {

/// A JSON value. What is no object, array or string is kept as its text.
struct Json {
    std::string name;           ///< of a member of an object
    std::string text;           ///< of a string, or of a number or word
    std::vector<Json> members;  ///< of an object
    std::vector<Json> items;    ///< of an array

    /// The member of that name; an empty value where there is none.
    const Json& operator[](std::string_view wanted) const {
        static const Json kNothing;
        for (const Json& member : members)
            if (member.name == wanted) return member;
        return kNothing;
    }
};

/// Reads JSON that is known to be well-formed; strings keep their escapes.
class JsonReader {
public:
    explicit JsonReader(std::string_view text) : text_(text) {}

    Json read() {
        skip_blanks();
        Json json;
        if (text_[at_] == '{') {
            read_members(json);
        } else if (text_[at_] == '[') {
            read_items(json);
        } else if (text_[at_] == '"') {
            json.text = read_string();
        } else {
            const std::size_t end = text_.find_first_of(",]} \n", at_);
            json.text = text_.substr(at_, end - at_);
            at_ = end;
        }
        skip_blanks();
        return json;
    }

private:
    void skip_blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
    }

    std::string read_string() {
        const std::size_t start = ++at_;
        while (text_.at(at_) != '"') at_ += text_[at_] == '\\' ? 2 : 1;
        return std::string(text_.substr(start, at_++ - start));
    }

    void read_members(Json& json) {
        for (++at_, skip_blanks(); text_.at(at_) != '}'; at_ += text_[at_] == ',' ? 1 : 0, skip_blanks()) {
            std::string name = read_string();
            at_ = text_.find(':', at_) + 1;
            json.members.push_back(read());
            json.members.back().name = std::move(name);
        }
        ++at_;
    }

    void read_items(Json& json) {
        for (++at_, skip_blanks(); text_.at(at_) != ']'; at_ += text_[at_] == ',' ? 1 : 0, skip_blanks())
            json.items.push_back(read());
        ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace enfilade
