#include "coarse/fields/field_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "common/io/json.hpp"
#include "common/io/whole_file.hpp"

namespace stria::coarse {
namespace {

constexpr const char *series = "fields.hdf.series", *collection = "fields.pvd";

std::string series_text(const std::vector<std::pair<std::string, double>>& files) {
    Json entries = Json::array();
    for (const auto& [name, time] : files) entries.push_back({{"name", name}, {"time", time}});
    return text_of({{"file-series-version", "1.0"}, {"files", std::move(entries)}});
}

std::string collection_text(const std::vector<std::pair<std::string, double>>& files) {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (const auto& [name, time] : files) {
        text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, name);
    }
    return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace

FieldWriter::FieldWriter(std::filesystem::path directory, FieldFormat format, std::vector<Step> written)
    : directory_(std::move(directory)), format_(format), steps_(std::move(written)) {
    remove_others();
}

void FieldWriter::remove_others() const {
    std::set<std::string> known;
    for (const Step& step : steps_) known.insert(std::filesystem::path(file_name(step.increment)).stem());
    std::error_code no_folder;
    std::vector<std::filesystem::path> others;
    for (const auto& entry : std::filesystem::directory_iterator(directory_ / fields_folder, no_folder))
        if (entry.path().filename().string().starts_with("step_") && !known.contains(entry.path().stem()))
            others.push_back(entry.path());
    for (const std::filesystem::path& file : others) std::filesystem::remove(file);
    if (!steps_.empty()) {
        if (!others.empty()) write_index();
        return;
    }
    // A run that begins anew may write in the other format: no index of the run before it must stay behind.
    for (const char* index : {series, collection}) std::filesystem::remove(directory_ / index);
}

std::string FieldWriter::file_name(std::int64_t increment) const {
    return fmt::format("{}/step_{:05}.{}", fields_folder, increment, format_ == FieldFormat::VtkHdf ? "hdf" : "vtu");
}

void FieldWriter::write(std::int64_t increment, const FieldData& data, double time) {
    std::filesystem::create_directories(directory_ / fields_folder);
    const std::filesystem::path path = directory_ / file_name(increment);
    if (format_ == FieldFormat::VtkHdf) {
        write_vtkhdf(path, data);
    } else {
        write_vtu(path, data);
    }
    std::erase_if(steps_, [&](const Step& step) { return step.increment == increment; });
    constexpr double right_behind = 1e-6;
    if (!steps_.empty()) time = std::max(time, steps_.back().time + right_behind);
    steps_.push_back({increment, time});
    write_index();
}

void FieldWriter::write_index() const {
    std::vector<std::pair<std::string, double>> files;
    for (const Step& step : steps_) files.emplace_back(file_name(step.increment), step.time);
    if (format_ == FieldFormat::VtkHdf) {
        write_whole_text(directory_ / series, series_text(files));
    } else {
        write_whole_text(directory_ / collection, collection_text(files));
    }
}

}  // namespace stria::coarse
