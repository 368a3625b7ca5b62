// Declares what a case file may say, one statement per key: reading, checks, error texts and the reference follow from
// it.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/schema/codec.hpp"

namespace stria::schema {

/// The keys of one table of the file and the members of T they fill. Defaults are those of a new T.
template <class T> class Section {
public:
    using Check = std::function<void(const T&, const Value&, const Place&)>;

    template <class M> Key& value(const std::string& name, M T::*member) {
        const std::optional<Value> standard = encode(T{}.*member);
        return add({.key = {.name = name, .type = type_of(M{}), .fallback = standard ? to_toml(*standard) : "absent"},
                    .read = [member](T& object, const Value& value, const Key& key,
                                     const Place& place) { decode(value, key, place, object.*member); },
                    .write = [member](const T& object) { return encode(object.*member); }});
    }

    /// A word of a fixed list.
    template <class E>
    Key& choice(const std::string& name, E T::*member, std::vector<std::pair<std::string, E>> words) {
        const auto word_of = [words](E wanted) {
            for (const auto& [word, meaning] : words)
                if (meaning == wanted) return word;
            return std::string();
        };
        const auto read = [member, words](T& object, const Value& value, const Key& key, const Place& place) {
            std::string text;
            decode(value, key, place, text);
            for (const auto& [word, meaning] : words)
                if (word == text) object.*member = meaning;
        };
        Key& key = add({.key = {.name = name, .type = "word", .fallback = '"' + word_of(T{}.*member) + '"'},
                        .read = read,
                        .write = [member, word_of](const T& object) { return encode(word_of(object.*member)); }});
        for (const auto& [word, meaning] : words) key.words.push_back(word);
        return key;
    }

    template <class M> Key& table(const std::string& name, M T::*member, const Section<M>& section) {
        return add({.key = {.name = name, .type = "table", .keys = section.keys()},
                    .read = [member, section](T& object, const Value& value, const Key& key,
                                              const Place& place) { object.*member = section.read(value, key, place); },
                    .write = [member, section](const T& object) { return section.write(object.*member); },
                    .always = true});
    }

    template <class M> Key& table(const std::string& name, std::optional<M> T::*member, const Section<M>& section) {
        return add({.key = {.name = name, .type = "table", .fallback = "absent", .keys = section.keys()},
                    .read = [member, section](T& object, const Value& value, const Key& key,
                                              const Place& place) { object.*member = section.read(value, key, place); },
                    .write = [member, section](const T& object) -> std::optional<Value> {
                        if (!(object.*member)) return std::nullopt;
                        return section.write(*(object.*member));
                    }});
    }

    template <class M> Key& list(const std::string& name, std::vector<M> T::*member, const Section<M>& section) {
        const auto read = [member, section](T& object, const Value& value, const Key& key, const Place& place) {
            int index = 0;
            for (const Value& entry : list_of(value, key, place))
                (object.*member).push_back(section.read(entry, key, place.inside(std::to_string(index++))));
        };
        const auto write = [member, section](const T& object) -> std::optional<Value> {
            List entries;
            for (const M& entry : object.*member) entries.push_back(section.write(entry));
            return Value{.data = std::move(entries)};
        };
        return add(
            {.key =
                 {.name = name, .type = "list of tables", .fallback = "[]", .repeated = true, .keys = section.keys()},
             .read = read,
             .write = write});
    }

    /// A key that must be there and can only say one thing.
    Key& constant(const std::string& name, const std::string& text) {
        const auto read = [](T&, const Value& value, const Key& key, const Place& place) {
            std::string given;
            decode(value, key, place, given);
        };
        return add({.key = {.name = name, .type = "word", .required = true, .words = {text}},
                    .read = read,
                    .write = [text](const T&) { return encode(text); }});
    }

    /// Another way to give a number: read, never written. Keys declared before it are already in the object.
    Key& input(const std::string& name, std::function<void(T&, double)> assign) {
        const auto read = [assign](T& object, const Value& value, const Key& key, const Place& place) {
            double number = 0.0;
            decode(value, key, place, number);
            assign(object, number);
        };
        return add({.key = {.name = name, .type = "number", .fallback = "absent"}, .read = read, .write = [](const T&) {
                        return std::nullopt;
                    }});
    }

    /// Defaults that follow from other keys: filled in where the key is absent, and written as values.
    void complete(std::function<void(T&)> completion) { complete_ = std::move(completion); }

    /// Keys that are not written where they say nothing.
    void leave_out(std::vector<std::string> names, std::function<bool(const T&)> where) {
        left_out_ = std::move(names);
        leave_out_ = std::move(where);
    }

    /// A condition that several keys must meet together.
    void check(Check condition) { checks_.push_back(std::move(condition)); }

    [[nodiscard]] T read(const Value& value, const Key& own, const Place& place) const {
        static_cast<void>(table_of(value, own, place));
        T object{};
        const Value nothing{.data = Table{}, .line = value.line};
        for (const Field& field : fields_) {
            const Value* given = find(value, field.key.name);
            const Place here = place.inside(field.key.name);
            if (given == nullptr && field.key.required) reject(here, value.line, "is missing: " + field.key.sentence);
            if (given == nullptr && field.always) given = &nothing;
            if (given != nullptr) field.read(object, *given, field.key, here);
        }
        if (complete_) complete_(object);
        for (const Check& condition : checks_) condition(object, value, place);
        return object;
    }

    [[nodiscard]] Value write(const T& object) const {
        const bool leaves_out = leave_out_ && leave_out_(object);
        Table table;
        for (const Field& field : fields_) {
            if (leaves_out && std::ranges::find(left_out_, field.key.name) != left_out_.end()) continue;
            if (std::optional<Value> value = field.write(object)) table.push_back({field.key.name, *std::move(value)});
        }
        return {.data = std::move(table)};
    }

    [[nodiscard]] std::vector<Key> keys() const {
        std::vector<Key> all;
        for (const Field& field : fields_) all.push_back(field.key);
        return all;
    }

private:
    struct Field {
        Key key;
        std::function<void(T&, const Value&, const Key&, const Place&)> read;
        std::function<std::optional<Value>(const T&)> write;
        bool always = false;  // read even where absent: the table may hold keys that must be given
    };

    Key& add(Field field) { return fields_.emplace_back(std::move(field)).key; }

    std::deque<Field> fields_;  // declarations hold references to its keys
    std::function<void(T&)> complete_;
    std::vector<std::string> left_out_;
    std::function<bool(const T&)> leave_out_;
    std::vector<Check> checks_;
};

}  // namespace stria::schema
