// Fields for ParaView: one file per written increment (VTKHDF 1.0, or VTU) and an index of them all that makes them a
// series.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "coarse/fields/vtk_files.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// Of the folder of results, where the files of fields are.
inline constexpr const char* fields_folder = "fields";

class FieldWriter {
public:
    struct Step {
        std::int64_t increment;
        double time;
    };

    /// `written`: the steps of a run that is resumed (its files are there already). Files of other steps go.
    FieldWriter(std::filesystem::path directory, FieldFormat format, std::vector<Step> written = {});

    /// Writes fields/step_00040.hdf (.vtu) and then fields.hdf.series (fields.pvd). A time that is not after the last
    /// one is put right behind it: readers want times that grow.
    void write(std::int64_t increment, const FieldData& data, double time);

    /// What a checkpoint remembers.
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }

private:
    [[nodiscard]] std::string file_name(std::int64_t increment) const;
    void write_index() const;
    void remove_others() const;

    std::filesystem::path directory_;
    FieldFormat format_;
    std::vector<Step> steps_;
};

}  // namespace stria::coarse
