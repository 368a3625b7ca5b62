#include "coarse/results/summary.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/io/whole_file.hpp"

namespace stria::coarse {
namespace {

std::string escaped(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        switch (c) {
        case '"':
            result += "\\\"";
            break;
        case '\\':
            result += "\\\\";
            break;
        case '\n':
            result += "\\n";
            break;
        case '\t':
            result += "\\t";
            break;
        default:
            if (static_cast<unsigned char>(c) < 0x20) {
                result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
            } else {
                result += c;
            }
        }
    }
    return result + '"';
}

Json to_json(const Timing& timing) {
    return Json::Object{{"mesh", timing.mesh},
                        {"setup", timing.setup},
                        {"coarse_factor", timing.coarse_factor},
                        {"growth", timing.growth},
                        {"fine_constitutive", timing.fine_constitutive},
                        {"fine_contact", timing.fine_contact},
                        {"fine_factor", timing.fine_factor},
                        {"exchange", timing.exchange},
                        {"coarse_solve", timing.coarse_solve},
                        {"output", timing.output},
                        {"checkpoint", timing.checkpoint},
                        {"total", timing.total}};
}

Json list_of(const std::vector<std::int64_t>& values) { return Json::Array(values.begin(), values.end()); }

Json last_values(const HistoryRow& row) {
    return Json::Object{{"tip", row.tip ? Json(*row.tip) : Json()},
                        {"increment", row.increment},
                        {"cycle", row.cycle},
                        {"x", row.x},
                        {"y", row.y},
                        {"a", row.a},
                        {"K_I", row.K_I},
                        {"K_II", row.K_II},
                        {"J", row.J},
                        {"CMOD", row.CMOD},
                        {"CTOD", row.CTOD},
                        {"plastic_zone", row.plastic_zone},
                        {"T_stress", row.T_stress},
                        {"J_spread", row.J_spread},
                        {"K_spread", row.K_spread}};
}

}  // namespace

void Json::append_to(std::string& text, const std::string& indent) const {
    const std::string inner = indent + "  ";
    const auto append_list = [&](char open, char close, const auto& list, const auto& append_item) {
        text += open;
        for (std::size_t k = 0; k < list.size(); ++k) {
            text += k > 0 ? ",\n" : "\n";
            text += inner;
            append_item(list[k]);
        }
        if (!list.empty()) text += '\n' + indent;
        text += close;
    };
    if (const auto* boolean = std::get_if<bool>(&value_)) {
        text += *boolean ? "true" : "false";
    } else if (const auto* integer = std::get_if<std::int64_t>(&value_)) {
        text += fmt::format("{}", *integer);
    } else if (const auto* number = std::get_if<double>(&value_); number && std::isfinite(*number)) {
        text += fmt::format("{}", *number);
    } else if (const auto* string = std::get_if<std::string>(&value_)) {
        text += escaped(*string);
    } else if (const auto* array = std::get_if<Array>(&value_)) {
        append_list('[', ']', *array, [&](const Json& item) { item.append_to(text, inner); });
    } else if (const auto* object = std::get_if<Object>(&value_)) {
        append_list('{', '}', *object, [&](const Member& member) {
            text += escaped(member.key) + ": ";
            member.value.append_to(text, inner);
        });
    } else {
        text += "null";
    }
}

std::string Json::text() const {
    std::string result;
    append_to(result, "");
    return result + '\n';
}

Json to_json(const Summary& summary) {
    Json::Array tips;
    for (const HistoryRow& row : summary.last) tips.push_back(last_values(row));
    Json::Object object{{"status", summary.status},
                        {"version", summary.version},
                        {"mode", summary.mode},
                        {"ranks", summary.ranks},
                        {"coarse_unknowns", summary.coarse_unknowns},
                        {"interface_unknowns", summary.interface_unknowns},
                        {"fine_unknowns", summary.fine_unknowns},
                        {"fine_points", summary.fine_points},
                        {"timing", to_json(summary.timing)},
                        {"newton_iterations", summary.newton_iterations},
                        {"multipliers", summary.multipliers},
                        {"step_cuts", summary.step_cuts},
                        {"zone_extensions", summary.zone_extensions},
                        {"yield_warnings", summary.yield_warnings},
                        {"flowing_rings", summary.flowing_rings}};
    for (const coupling::NamedWorkCount& count : coupling::named_work_counts)
        object.push_back({count.name, summary.work.*count.value});
    object.push_back({"points_of_ranks", list_of(summary.points_of_ranks)});
    object.push_back({"multipliers_of_ranks", list_of(summary.multipliers_of_ranks)});
    object.push_back({"tips", tips});
    return object;
}

void write_json(const std::filesystem::path& path, const Json& value) { write_whole_text(path, value.text()); }

}  // namespace stria::coarse
