#include "common/case/not_in_this_version.hpp"

namespace stria {

namespace {

using schema::NotYet;
using schema::Value;

NotYet key(std::string path, std::string instead = "") { return {std::move(path), {}, "", std::move(instead)}; }

NotYet word(std::string path, const std::string& word, std::string instead) {
    const auto applies = [word](const Value& value) {
        const auto* text = std::get_if<std::string>(&value.data);
        return text != nullptr && *text == word;
    };
    return {std::move(path), applies, '"' + word + '"', std::move(instead)};
}

/// [material.NAME]: any table below [material] that has its own modulus.
NotYet named_material(std::string path, std::string instead) {
    const auto applies = [](const Value& value) { return schema::find(value, "young") != nullptr; };
    return {std::move(path), applies, "", std::move(instead)};
}

NotYet above(std::string path, double bound, std::string instead) {
    const auto applies = [bound](const Value& value) {
        if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole) > bound;
        const auto* number = std::get_if<double>(&value.data);
        return number != nullptr && *number > bound;
    };
    return {std::move(path), applies, "> " + std::to_string(static_cast<int>(bound)), std::move(instead)};
}

}  // namespace

const std::vector<NotYet>& not_in_this_version() {
    static const std::string linear = "isotropic hardening is linear { modulus }";
    static const std::string one_material = "the whole body is of one [material]";
    static const std::string specimens = "specimens are sent, mt, ct, plate";
    static const std::vector<NotYet> list = {
        key("mesh.file", specimens),
        word("material.isotropic.law", "voce", linear),
        word("material.isotropic.law", "power", linear),
        word("material.isotropic.law", "table", linear),
        key("material.isotropic.Q", linear),
        key("material.isotropic.b", linear),
        key("material.isotropic.n", linear),
        key("material.isotropic.alpha", linear),
        key("material.isotropic.plastic_strain", linear),
        key("material.isotropic.stress", linear),
        above("material.kinematic.gamma", 0.0, "gamma is 0 (Prager)"),
        named_material("material.*", one_material),
        key("regions", one_material),
    };
    return list;
}

}  // namespace stria
