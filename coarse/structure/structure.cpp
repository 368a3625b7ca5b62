#include "coarse/structure/structure.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/linear/lower_triangle.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {
namespace {

template <class Make> auto timed(double& seconds, const Make& make) {
    const Stopwatch watch(seconds);
    return make();
}

// A part of other elements is forgotten first, lest two of them take twice the memory.
std::shared_ptr<const BodyPart> far_part(const Scene& scene, const ElementSet& far, StructureFactors& known,
                                         StructureSeconds& seconds) {
    if (known.far && !known.far->is_of(far, nullptr)) known = {};
    if (far.none() || known.far) return known.far;
    return std::make_shared<const BodyPart>(scene, far, nullptr, seconds);
}

std::shared_ptr<const BodyPart> part_on(std::shared_ptr<const BodyPart> below, const Scene& scene,
                                        const ElementSet& elements, std::shared_ptr<const BodyPart> known,
                                        StructureSeconds& seconds) {
    if (elements.none()) return nullptr;
    if (known && known->is_of(elements, below.get())) return known;
    known.reset();
    return std::make_shared<const BodyPart>(scene, elements, std::move(below), seconds);
}

}  // namespace

Structure::Structure(const Scene& scene, ElementSet in_zone, const StillElements& still, StructureFactors known)
    : far_(far_part(scene, still.far, known, seconds_)),
      middle_(part_on(far_, scene, still.middle, std::move(known.middle), seconds_)),
      behind_(part_on(below_behind(), scene, still.behind, std::move(known.behind), seconds_)),
      elements_(timed(seconds_.assembly, [&] { return CoarseElements(scene, std::move(in_zone), still); })),
      numbering_(timed(seconds_.assembly,
                       [&] {
                           return LeafNumbering(elements_, {far_.get(), middle_.get(), behind_.get()});
                       })),
      core_(factor(std::move(known.core))), leaf_(below(), numbering_.places_of_rim_below(), core_->leaf),
      loads_(timed(seconds_.factor, [&] { return CondensedLoads(elements_, numbering_, leaf_); })) {
    find_near_supports();
}

/// Orders the elimination of the core, assembles and factors it.
std::shared_ptr<const CoreFactor> Structure::factor(std::shared_ptr<const CoreFactor> known) {
    const IndexLists of_elements = timed(seconds_.ordering, [&] { return numbering_.order_elimination(elements_); });
    const int unknowns = static_cast<int>(numbering_.core_unknowns().size());
    SparseMatrix lower =
        timed(seconds_.assembly, [&] { return core_stiffness(elements_, of_elements, unknowns, below().get()); });
    const Stopwatch watch(seconds_.factor);
    return factor_core(std::move(lower), static_cast<int>(free_places().size()), std::move(known));
}

void Structure::find_near_supports() {
    UnknownSet seen(scene().enriched.unknowns);
    std::vector<int> near;  // and supported
    std::ranges::set_intersection(elements_.near(), elements_.supported(), std::back_inserter(near));
    elements_.for_each_unknowns(near, [&](int, std::span<const int> unknowns) {
        for (const int unknown : unknowns) seen.insert(unknown);
    });
    for (const PrescribedUnknown& p : scene().prescribed)
        if (seen.contains(p.unknown)) near_supports_.push_back(p);
}

Eigen::VectorXd Structure::on_free_places(const Eigen::VectorXd& gamma_values) const {
    return gather(gamma_values, free_places());
}

Eigen::VectorXd Structure::boundary_load(const LoadFactors& factors) const {
    Eigen::VectorXd load = factors.main * loads_.unit().boundary + loads_.initial().boundary;
    for (std::size_t k = 0; k < loads_.cases().size(); ++k) {
        const double factor = factors.of_case(static_cast<Eigen::Index>(k));
        if (factor != 0.0) load += factor * loads_.cases()[k].boundary;
    }
    return load;
}

Eigen::VectorXd Structure::expand(const Eigen::VectorXd& gamma_displacement, const LoadFactors& factors,
                                  double initial) const {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(scene().enriched.unknowns);
    const Eigen::VectorXd inside = interior_load(factors, initial, 0, loads_.unit().interior.size());
    u(numbering_.unknowns()) = leaf_.expand({inside, {}}, on_free_places(gamma_displacement));
    impose(scene().prescribed, factors, u);
    return u;
}

Eigen::VectorXd Structure::interior_load(const LoadFactors& factors, double initial, Eigen::Index from,
                                         Eigen::Index count) const {
    const auto part = [&](const ReducedLoad& load) { return load.interior.segment(from, count); };
    Eigen::VectorXd load = factors.main * part(loads_.unit());
    for (std::size_t k = 0; k < loads_.cases().size(); ++k) {
        const double factor = factors.of_case(static_cast<Eigen::Index>(k));
        if (factor != 0.0) load += factor * part(loads_.cases()[k]);
    }
    if (initial != 0.0 && elements_.initial().load.size() > 0) load += initial * part(loads_.initial());
    return load;
}

Eigen::VectorXd Structure::expand_core(const Eigen::VectorXd& gamma_displacement, const LoadFactors& factors,
                                       double initial, Eigen::VectorXd& u) const {
    const Eigen::Index below = unknowns() - std::ssize(core_unknowns());
    const Eigen::VectorXd load = interior_load(factors, initial, below, loads_.unit().interior.size() - below);
    const Eigen::VectorXd x = leaf_.expand_above(load, on_free_places(gamma_displacement));
    Eigen::Index k = 0;
    for (const int unknown : numbering_.core_unknowns()) u[unknown] = x[k++];
    return leaf_.on_rim(x);
}

/// What lies inside of the parts on the far one, from the top down; and supports.
void Structure::expand_below(Eigen::VectorXd on_rim, const LoadFactors& factors, double initial,
                             Eigen::VectorXd& u) const {
    int end = unknowns() - static_cast<int>(std::ssize(core_unknowns()));
    for (const BodyPart* part : {behind_.get(), middle_.get()}) {
        if (part == nullptr) continue;
        const int inside = part->inner_count(), first = end - inside;
        const Eigen::VectorXd x = part->expand_own(interior_load(factors, initial, first, inside), on_rim);
        for (int k = 0; k < inside; ++k) u[numbering_.unknowns()[at(first + k)]] = x[k];
        on_rim = part->on_rim_below(x);
        end = first;
    }
    impose(near_supports_, factors, u);
}

const Eigen::VectorXd& Structure::near_of_unit_load(std::int64_t& found) const {
    if (!near_of_unit_load_) {
        expand_near({}, 1.0, 0.0, near_of_unit_load_.emplace(Eigen::VectorXd::Zero(scene().enriched.unknowns)));
        ++found;
    }
    return *near_of_unit_load_;
}

std::shared_ptr<const FarDisplacement> Structure::beside_near(const LoadFactors& factors, double initial,
                                                              Eigen::VectorXd& u) const {
    impose(scene().prescribed, factors, u);
    if (!far_) return nullptr;
    const int inside = numbering_.far_count();
    const auto first = numbering_.unknowns().begin();
    return std::make_shared<const FarDisplacement>(far_, std::vector<int>(first, first + inside),
                                                   interior_load(factors, initial, 0, inside), gather(u, rim()));
}

Eigen::VectorXd Structure::far_force(const Eigen::VectorXd& rim_displacement) const {
    if (!far_) return rim_displacement;
    return times_lower(far_->tangent(), rim_displacement);
}

Eigen::VectorXd Structure::expand_far(const Eigen::VectorXd& rim_displacement) const {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(scene().enriched.unknowns);
    if (!far_) return u;
    const Eigen::VectorXd x = far_->expand({Eigen::VectorXd::Zero(numbering_.far_count()), {}}, rim_displacement);
    for (int i = 0; i < numbering_.far_count(); ++i) u[numbering_.unknowns()[at(i)]] = x[i];
    u(rim()) = rim_displacement;
    return u;
}

double Structure::factor_entries() const {
    double entries = core_->leaf->factor_entries();
    for (const BodyPart* part : {far_.get(), middle_.get(), behind_.get()})
        if (part != nullptr) entries += part->factor_entries();
    return entries;
}

}  // namespace stria::coarse
