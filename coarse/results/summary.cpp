#include "coarse/results/summary.hpp"

namespace stria::coarse {

STRIA_MEMBERS(Timing, mesh, setup, coarse_factor, growth, fine_constitutive, fine_contact, fine_factor, exchange,
              coarse_solve, output, checkpoint, total)

namespace {

Json to_json(const Timing& timing) {
    Json seconds = Json::object();
    for_each_member(timing, [&](std::string_view phase, double s) { seconds[std::string(phase)] = s; });
    return seconds;
}

Json last_values(const HistoryRow& row, double K_initial, double closure_distance) {
    return {{"tip", row.tip ? Json(*row.tip) : Json()},
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
            {"K_initial", K_initial},
            {"closure_distance", closure_distance}};
}

}  // namespace

Json to_json(const Summary& summary) {
    Json tips = Json::array();
    const auto of_tip = [](const std::vector<double>& values, std::size_t t) {
        return t < values.size() ? values[t] : missing;
    };
    for (std::size_t t = 0; t < summary.last.size(); ++t)
        tips.push_back(last_values(summary.last[t], of_tip(summary.K_initial, t), of_tip(summary.closure_distance, t)));
    Json object{{"status", to_text(summary.status)},
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
    for_each_member(summary.work,
                    [&](std::string_view name, std::int64_t count) { object[std::string(name)] = count; });
    object["N"] = summary.N;
    object["life"] = summary.life ? Json(*summary.life) : Json();
    object["points_of_ranks"] = summary.points_of_ranks;
    object["multipliers_of_ranks"] = summary.multipliers_of_ranks;
    object["tips"] = std::move(tips);
    object["warnings"] = summary.warnings;
    return object;
}

}  // namespace stria::coarse
