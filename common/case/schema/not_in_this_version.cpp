#include "common/case/schema/not_in_this_version.hpp"

namespace stria {

namespace {

using schema::NotYet;
using schema::Value;

NotYet key(std::string path, std::string instead = "") { return {std::move(path), {}, std::move(instead)}; }

/// [material.NAME]: any table below [material] that has its own modulus.
NotYet named_material(std::string path, std::string instead) {
    const auto applies = [](const Value& value) { return schema::find(value, "young") != nullptr; };
    return {std::move(path), applies, std::move(instead)};
}

}  // namespace

const std::vector<NotYet>& not_in_this_version() {
    static const std::string one_material = "other materials are those of [[region]]";
    static const std::vector<NotYet> list = {
        named_material("material.*", one_material),
        key("regions", one_material),
    };
    return list;
}

}  // namespace stria
