// summary.json: what a run was, how large, how long, and where its tips ended; and the few lines of JSON it needs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coarse/results/tables.hpp"

namespace stria::coarse {

/// A JSON value to be written; objects keep the order of their members. Numbers that are not finite become null.
class Json {
public:
    struct Member;
    using Array = std::vector<Json>;
    using Object = std::vector<Member>;

    Json() = default;  // null
    Json(bool value) : value_(value) {}
    Json(int value) : value_(std::int64_t{value}) {}
    Json(std::int64_t value) : value_(value) {}
    Json(double value) : value_(value) {}
    Json(const char* value) : value_(std::string(value)) {}
    Json(std::string value) : value_(std::move(value)) {}
    Json(Array values) : value_(std::move(values)) {}
    Json(Object members) : value_(std::move(members)) {}

    /// Text with an indent of two spaces, one member a line, ended by a line break.
    [[nodiscard]] std::string text() const;

private:
    void append_to(std::string& text, const std::string& indent) const;

    std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object> value_;
};

struct Json::Member {
    std::string key;
    Json value;
};

/// Seconds per phase. mesh + setup + exchange + coarse_solve + output make the total; the others are parts of those.
struct Timing {
    double mesh = 0, setup = 0, coarse_factor = 0, growth = 0, fine_constitutive = 0, fine_contact = 0, fine_factor = 0;
    double exchange = 0, coarse_solve = 0, output = 0, checkpoint = 0, total = 0;
};

struct Summary {
    std::string status;  // "done", "running", "interrupted", "failed"
    std::string version;
    std::string mode;  // "mpi", "inprocess", "monolithic"
    int ranks = 1;
    std::int64_t coarse_unknowns = 0, interface_unknowns = 0, fine_unknowns = 0, fine_points = 0;
    std::int64_t newton_iterations = 0;
    // Contact multipliers, halved increments, zone extensions, unheeded yield checks, increments in
    // which a tip had no ring outside its plastic zone, and work done and skipped.
    std::int64_t multipliers = 0, step_cuts = 0, zone_extensions = 0, yield_warnings = 0, flowing_rings = 0;
    coupling::WorkCounts work;
    std::vector<std::int64_t> points_of_ranks, multipliers_of_ranks;  // of each fine rank
    Timing timing;
    std::vector<HistoryRow> last;  // last row of each tip
};

Json to_json(const Summary& summary);

/// Whole or not at all.
void write_json(const std::filesystem::path& path, const Json& value);

}  // namespace stria::coarse
