// Failures of the fine component, as a test asks for them.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/error.hpp"
#include "coupling/fine_scale.hpp"
#include "fine/zone/fine_model.hpp"

namespace stria::test {

/// Hands everything on to the fine component of a case, but for failures as asked for.
class FailsSometimes final : public coupling::FineScale {
public:
    explicit FailsSometimes(const Case& input) : model_(input) {}

    void set_patch(const coupling::Patch& patch) override { model_.set_patch(patch); }
    void request(const coupling::PatchDisplacement& displacement) override {
        load_factor_ = displacement.load_factor;
        model_.request(displacement);
    }
    coupling::PatchResponse collect() override {
        coupling::PatchResponse response = model_.collect();
        const auto is_here = [this](double load) { return std::abs(load - load_factor_) < 1e-9; };
        if (fails || (!only_at.empty() && std::ranges::none_of(only_at, is_here)))
            throw NumericalFailure("as asked for");
        return response;
    }
    coupling::StepReport commit(const coupling::Commit& what) override { return model_.commit(what); }
    void rollback() override { model_.rollback(); }
    coupling::ZoneState state() override { return model_.state(); }
    coupling::ZoneSnapshot snapshot() override { return model_.snapshot(); }
    void restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) override {
        model_.restore(patch, snapshot);
    }

    bool fails = false;
    std::vector<double> only_at;  // load factors; empty: all

private:
    fine::FineModel model_;
    double load_factor_ = 0.0;
};

}  // namespace stria::test
