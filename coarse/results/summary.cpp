#include "coarse/results/summary.hpp"

namespace stria::coarse {

STRIA_MEMBERS(Timing, mesh, setup, coarse_factor, growth, fine_constitutive, fine_contact, fine_factor, exchange,
              coarse_solve, output, checkpoint, total)

namespace {

Json to_json(const Timing& timing) {
    Json::Object seconds;
    for_each_member(timing, [&](std::string_view phase, double s) { seconds.push_back({std::string(phase), s}); });
    return seconds;
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
                        {"K_spread", row.K_spread},
                        {"K_initial", row.K_initial}};
}

}  // namespace

Json to_json(const Summary& summary) {
    Json::Array tips;
    for (const HistoryRow& row : summary.last) tips.push_back(last_values(row));
    Json::Object object{{"status", to_text(summary.status)},
                        {"version", summary.version},
                        {"mode", summary.mode},
                        {"ranks", summary.ranks},
                        {"mesh_file", summary.mesh_file.empty() ? Json() : Json(summary.mesh_file)},
                        {"coarse_unknowns", summary.coarse_unknowns},
                        {"interface_unknowns", summary.interface_unknowns},
                        {"fine_unknowns", summary.fine_unknowns},
                        {"fine_points", summary.fine_points},
                        {"timing", to_json(summary.timing)},
                        {"newton_iterations", summary.counts.newton_iterations},
                        {"multipliers", summary.multipliers},
                        {"step_cuts", summary.step_cuts},
                        {"zone_extensions", summary.counts.zone_extensions},
                        {"yield_warnings", summary.counts.yield_warnings},
                        {"flowing_rings", summary.counts.flowing_rings},
                        {"overlapping_faces", summary.counts.overlapping_faces},
                        {"mesh_splits", summary.counts.mesh_splits}};
    for_each_member(summary.work, [&](std::string_view name, std::int64_t count) {
        object.push_back({std::string(name), count});
    });
    object.push_back({"N", summary.N});
    object.push_back({"life", summary.life ? Json(*summary.life) : Json()});
    object.push_back({"points_of_ranks", list_of(summary.points_of_ranks)});
    object.push_back({"multipliers_of_ranks", list_of(summary.multipliers_of_ranks)});
    object.push_back({"tips", tips});
    object.push_back({"warnings", Json::Array(summary.warnings.begin(), summary.warnings.end())});
    return object;
}

}  // namespace stria::coarse
