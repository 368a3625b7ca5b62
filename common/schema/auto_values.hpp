// Keys of the case file that take a value or the word "auto". The functions stand beside the type: that is where a
// Section looks for them.
#pragma once

#include "common/or_auto.hpp"
#include "common/schema/schema.hpp"

namespace stria {

template <class M> std::string type_of(const OrAuto<M>&) { return schema::type_of(M{}) + " or \"auto\""; }

template <class M>
void decode(const schema::Value& value, const schema::Key& key, const schema::Place& place, OrAuto<M>& out) {
    const std::string* word = std::get_if<std::string>(&value.data);
    if (word != nullptr && *word != "auto") schema::reject(place, value, key, "must be " + type_of(out));
    M read{};
    if (word == nullptr) schema::decode(value, key, place, read);
    out = word != nullptr ? OrAuto<M>() : OrAuto<M>(read);
}

template <class M> std::optional<schema::Value> encode(const OrAuto<M>& value) {
    return value.is_auto() ? schema::encode(std::string("auto")) : schema::encode(value.value());
}

}  // namespace stria
