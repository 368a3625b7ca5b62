#include "coarse/condensed_equilibrium.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <numeric>

#include "common/error.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {
namespace {

double largest(const Eigen::VectorXd& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0; }

}  // namespace

CondensedEquilibrium::CondensedEquilibrium(const Structure& structure, coupling::FineScale* fine,
                                           const Eigen::VectorXd& committed, double load_factor)
    : structure_(structure), scene_(structure.scene()), fine_(fine), load_factor_(load_factor) {
    committed_ = gather(committed, structure_.gamma());
    trial_ = committed_;
    last_increment_ = Eigen::VectorXd::Zero(committed_.size());
    for (const PrescribedUnknown& p : scene_.prescribed) {
        const auto found = std::ranges::lower_bound(structure_.gamma(), p.unknown);
        if (found != structure_.gamma().end() && *found == p.unknown)
            imposed_.emplace_back(found - structure_.gamma().begin(), p.value);
    }
}

Eigen::VectorXd CondensedEquilibrium::on_free(const Eigen::VectorXd& gamma) const {
    return gather(gamma, structure_.free_places());
}

void CondensedEquilibrium::impose(Eigen::VectorXd& gamma) const {
    for (const auto& [place, value] : imposed_) gamma[place] = load_factor_ * value;
}

void CondensedEquilibrium::begin(double load_factor, double predictor) {
    load_factor_ = load_factor;
    predictor_ = predictor;
    iteration_ = 0;
    trial_ = committed_ + predictor * last_increment_;
    impose(trial_);
}

Residual CondensedEquilibrium::linearise() {
    Residual result;
    result.scale = largest(load_factor_ * scene_.unit_force);
    if (fine_ == nullptr) return result;
    {
        const Stopwatch watch(exchange_s_);
        fine_->request({iteration_, predictor_, load_factor_, trial_});
        // Meanwhile the structure's part, which needs no answer.
        residual_ = load_factor_ * structure_.unit_load() - structure_.tangent() * on_free(trial_);
        response_ = fine_->collect();
        if (scene_.input.coupling.state == "newton")
            (void)fine_->state();  // the user pays for seeing every iterate cross
    }
    residual_ -= on_free(response_.force);
    result.boundary = largest(residual_);
    result.interior = response_.interior_residual;
    result.contact = response_.contact_residual;
    result.scale = std::max(result.scale, response_.interior_force);
    result.yielding_points =
        std::reduce(response_.digest.yielding_points.begin(), response_.digest.yielding_points.end());
    result.closed = static_cast<int>(std::ranges::count(response_.digest.status, std::int8_t{1}));
    result.status_changes = response_.digest.status_changes;
    return result;
}

double CondensedEquilibrium::solve() {
    if (fine_ == nullptr) return 0.0;
    const auto n = std::ssize(structure_.free_places());
    Eigen::MatrixXd tangent = structure_.tangent();
    for (Eigen::Index j = 0; j < n; ++j) {
        for (Eigen::Index i = 0; i < n; ++i) {
            tangent(i, j) += response_.tangent(structure_.free_places()[static_cast<std::size_t>(i)],
                                               structure_.free_places()[static_cast<std::size_t>(j)]);
        }
    }
    const Eigen::LLT<Eigen::MatrixXd> cholesky(tangent);
    correction_ = cholesky.info() == Eigen::Success ? Eigen::VectorXd(cholesky.solve(residual_))
                                                    : Eigen::VectorXd(tangent.partialPivLu().solve(residual_));
    if (!correction_.allFinite())
        throw NumericalFailure("the tangent of the structure is singular: a part of the body moves freely");
    return largest(correction_) /
           std::max({largest(trial_), largest(correction_), response_.interior_displacement, 1e-300});
}

void CondensedEquilibrium::apply() {
    if (fine_ == nullptr) return;
    for (std::size_t k = 0; k < structure_.free_places().size(); ++k)
        trial_[structure_.free_places()[k]] += correction_[static_cast<Eigen::Index>(k)];
    ++iteration_;
}

coupling::StepReport CondensedEquilibrium::commit(bool reversal) {
    last_increment_ = trial_ - committed_;
    committed_ = trial_;
    if (fine_ == nullptr) return {};
    const Stopwatch watch(exchange_s_);
    coupling::StepReport report = fine_->commit(reversal);
    if (scene_.input.coupling.state != "auto") (void)fine_->state();
    return report;
}

void CondensedEquilibrium::rollback() {
    trial_ = committed_;
    if (fine_ != nullptr) fine_->rollback();
}

Eigen::VectorXd CondensedEquilibrium::structure_displacement() const { return structure_.expand(trial_, load_factor_); }

Eigen::VectorXd CondensedEquilibrium::reactions() const {
    Eigen::VectorXd forces = structure_.forces_on_prescribed(structure_displacement());
    for (std::size_t k = 0; k < scene_.prescribed.size(); ++k) {
        const auto found = std::ranges::lower_bound(structure_.gamma(), scene_.prescribed[k].unknown);
        if (fine_ != nullptr && found != structure_.gamma().end() && *found == scene_.prescribed[k].unknown) {
            forces[static_cast<Eigen::Index>(k)] += response_.force[found - structure_.gamma().begin()];
        }
    }
    return forces;
}

}  // namespace stria::coarse
