#include "coarse/fracture/ring_forms.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "coarse/model/rings.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"
#include "common/material/initial_strain.hpp"

namespace stria::coarse {
namespace {

using CornerGradients = Eigen::Matrix<double, 4, 2>;  // of the functions that interpolate q

const CornerGradients& corner_gradients(const PlainOperator& op, const EnrichedMesh&, std::size_t q) {
    return op.gradients[q];
}

CornerGradients corner_gradients(const ElementOperator& op, const EnrichedMesh& mesh, std::size_t q) {
    return shape_q4(corners_of_element(mesh, op.element), op.points[q].xi).gradient;
}

bool is_mean(const PlainOperator& op) { return op.mean_dilatation; }
bool is_mean(const ElementOperator& op) { return !op.mean.empty(); }
const PlainOperator::Gradient& mean_of(const PlainOperator& op, int) { return op.mean; }
auto mean_of(const ElementOperator& op, int region) { return op.mean[at(region)]; }

constexpr int most_regions = 2;  // of mean dilatation
int regions_of(const PlainOperator& op) { return is_mean(op) ? 1 : 0; }
int regions_of(const ElementOperator& op) { return static_cast<int>(op.mean.size()); }

/// What a linear form of the stress and of u_,1 makes of each value of an element: point by point.
template <class Operator> class ElementForm {
public:
    explicit ElementForm(const Operator& op) : values_(Operator::Values::Zero(std::ssize(op.unknowns))) {}

    /// The adjoint of sigma = C eps(u), u_,1 at point q, of which op.strain() and op.displacement_gradient() are.
    void add(const Operator& op, std::size_t q, const MandelMatrix& elastic, const MutualWeights& weights,
             const Vec2& along) {
        const double xx = elastic(0, 0) * weights.xx + elastic(0, 1) * weights.yy;
        const double yy = elastic(1, 0) * weights.xx + elastic(1, 1) * weights.yy;
        const double zz = elastic(2, 0) * weights.xx + elastic(2, 1) * weights.yy;
        const double xy = 0.5 * elastic(3, 3) * weights.xy;
        const double weight = op.points[q].weight, pressure = is_mean(op) ? (xx + yy + zz) / 3.0 : 0.0;
        const Vec2 slope = weight * weights.slope;
        const Vec2 by_x = weight * Vec2(xx - pressure, xy) + along.x() * slope;
        const Vec2 by_y = weight * Vec2(xy, yy - pressure) + along.y() * slope;
        const auto& gradients = op.gradients[q];
        for (Eigen::Index f = 0; f < gradients.rows(); ++f)
            values_.template segment<2>(2 * f) += gradients(f, 0) * by_x + gradients(f, 1) * by_y;
        pressure_[at(op.points[q].region)] += weight * pressure;
        slope_ += slope;
    }

    /// Once all points are there.
    [[nodiscard]] typename Operator::Values values(const Operator& op) const {
        typename Operator::Values values = values_;
        for (int region = 0; region < regions_of(op); ++region) {
            const auto& mean = mean_of(op, region);
            values.reshaped(2, mean.rows()) += pressure_[at(region)] * mean.transpose();
        }
        return values;
    }

    /// Where the body turns by 1.
    [[nodiscard]] double of_turning(const Vec2& along) const { return slope_.dot(turned(along)); }

private:
    typename Operator::Values values_;
    std::array<double, most_regions> pressure_{};
    Vec2 slope_ = Vec2::Zero();
};

/// Strains and displacement gradients at the points of an element, with what they share worked out once.
template <class Operator> class ElementStrains {
public:
    using Values = typename Operator::Values;

    ElementStrains(const Operator& op, const Values& values) : op_(op), values_(values) {
        for (int region = 0; region < regions_of(op); ++region) {
            const auto& mean = mean_of(op, region);
            dilatation_[at(region)] = values_.reshaped(2, mean.rows()).cwiseProduct(mean.transpose()).sum();
        }
    }

    [[nodiscard]] Eigen::Matrix2d gradient(std::size_t q) const {
        return values_.reshaped(2, op_.gradients[q].rows()) * op_.gradients[q];
    }
    /// op.strain(), from the gradient.
    [[nodiscard]] Mandel strain(std::size_t q, const Eigen::Matrix2d& gradient) const {
        if (!is_mean(op_)) return strain_of(gradient);
        const double missing = dilatation_[at(op_.points[q].region)] - gradient.trace();
        return strain_of(gradient) + missing / 3.0 * mandel_identity;
    }

private:
    const Operator& op_;
    const Values& values_;
    std::array<double, most_regions> dilatation_{};
};

/// Those in a set, or all but those; one of size zero holds none.
std::vector<int> near_elements(const CoarseElements& elements, const ElementSet& set, bool inside) {
    std::vector<int> found;
    std::ranges::copy_if(elements.near(), std::back_inserter(found),
                         [&](int element) { return set.holds(element) == inside; });
    return found;
}

RingWeights weights_of(const CoarseElements& elements, int tip, std::span<const Annulus> rings,
                       const std::vector<int>& among) {
    const EnrichedMesh& mesh = elements.scene().enriched;
    return {mesh, mesh.tips[at(tip)], rings, among, !rings.back().one_metal};
}

}  // namespace

RingForms::RingForms(const CoarseElements& elements, int tip, const ElementSet& for_K)
    : tip_(tip), rings_(rings_about(elements.scene(), tip)), all_{0, weights_of(elements, tip, rings_,
                                                                                near_elements(elements, for_K, false))},
      for_K_{first_for_K(rings_), weights_of(elements, tip, std::span(rings_).subspan(first_for_K(rings_), 1),
                                             near_elements(elements, for_K, true))} {
    find_forms(elements, all_);
    find_forms(elements, for_K_);
}

bool RingForms::serve_beside(const ElementSet& zone) const {
    return std::ranges::all_of(for_K_.weights.elements(), [&](int element) { return zone.contains(element); });
}

void RingForms::find_forms(const CoarseElements& elements, Part& part) const {
    const Scene& scene = elements.scene();
    const Tip& about = scene.enriched.tips[at(tip_)];
    const AuxiliaryFields auxiliary(about, scene.elastic(about));
    constexpr std::size_t most_values = 8;  // of most elements in a ring
    part.forms.reserve(3 * (most_values + 1) * part.weights.entries() + most_values * part.weights.elements().size());
    elements.for_each(part.weights.elements(), [&](const auto& op) { append_forms(op, auxiliary, scene, part); });
}

template <class Operator>
void RingForms::append_forms(const Operator& op, const AuxiliaryFields& auxiliary, const Scene& scene,
                             Part& part) const {
    const std::span<const RingWeights::Entered> entered = part.weights.of(part.first.size());
    const Tip& about = scene.enriched.tips[at(tip_)];
    const MandelMatrix& elastic = scene.stiffness(op.element);
    const int material = scene.enriched.material_of(op.element), side = branch_side(scene.enriched, op.element);
    const Elasticity &of_tip = scene.elastic(about), &here = scene.elastic(op.element);
    const bool is_of_tips_metal = scene.materials.are_alike(about.material, material);
    const ElementForm<Operator> zero(op);
    std::vector<std::array<ElementForm<Operator>, 3>> forms(entered.size(), {zero, zero, zero});
    typename Operator::Values turning = Operator::Values::Zero(std::ssize(op.unknowns));
    double area = 0.0;
    for (std::size_t q = 0; q < op.points.size(); ++q) {
        const IntegrationPoint& point = op.points[q];
        const std::array<AuxiliaryField, 3> fields = auxiliary.at(point.x, point.side != 0 ? point.side : side);
        const CornerGradients& gradients = corner_gradients(op, scene.enriched, q);
        const auto& own = op.gradients[q];
        for (Eigen::Index f = 0; f < own.rows(); ++f)
            turning.template segment<2>(2 * f) += 0.5 * point.weight * Vec2(-own(f, 1), own(f, 0));
        area += point.weight;
        std::array<Mandel, 3> stress_slopes;
        if (!is_of_tips_metal) stress_slopes = auxiliary.stress_slopes(point.x, point.side != 0 ? point.side : side);
        for (std::size_t k = 0; k < entered.size(); ++k) {
            const Vec2 dq = gradients.transpose() * entered[k].q;
            for (std::size_t mode = 0; mode < 3; ++mode) {
                MutualWeights weights(fields[mode], about.direction, dq);
                if (!is_of_tips_metal) {
                    const double value = shape_values(point.xi).dot(entered[k].q), ahead = about.direction.dot(dq);
                    const Mandel slope = weighted_slope(fields[mode], stress_slopes[mode], value, ahead);
                    weights += of_tip.strain_in_plane(slope) - here.strain_in_plane(slope);
                }
                forms[k][mode].add(op, q, elastic, weights, about.direction);
            }
        }
    }
    part.first.push_back(part.forms.size());
    part.unknowns.insert(part.unknowns.end(), op.unknowns.begin(), op.unknowns.end());
    part.first_unknown.push_back(part.unknowns.size());
    part.area.push_back(area);
    part.forms.insert(part.forms.end(), turning.begin(), turning.end());
    for (const std::array<ElementForm<Operator>, 3>& of_ring : forms) {
        for (const ElementForm<Operator>& form : of_ring) {
            const typename Operator::Values values = form.values(op);
            part.forms.insert(part.forms.end(), values.begin(), values.end());
        }
        for (const ElementForm<Operator>& form : of_ring) part.forms.push_back(form.of_turning(about.direction));
    }
}

std::vector<DomainIntegral> RingForms::values(const CoarseElements& elements, const Eigen::VectorXd& u) const {
    const Scene& scene = elements.scene();
    const Tip& about = scene.enriched.tips[at(tip_)];
    const MandelMatrix& elastic = scene.materials.stiffness(about.material);
    std::vector<DomainIntegral> result(rings_.size());
    const auto add = [&](std::size_t place, const auto& op) {
        const auto local = gather(u, op.unknowns);
        const ElementStrains strains(op, local);
        Eigen::Vector4d own = Eigen::Vector4d::Zero();  // what J has of q at each corner
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const Eigen::Matrix2d gradient = strains.gradient(q);
            const Mandel strain = strains.strain(q, gradient), stress = elastic * strain;
            const Vec2 momentum = energy_momentum(about, stress, gradient, 0.5 * stress.dot(strain));
            own += corner_gradients(op, scene.enriched, q) * (op.points[q].weight * momentum);
        }
        const std::span<const RingWeights::Entered> entered = all_.weights.of(place);
        for (std::size_t k = 0; k < entered.size(); ++k) {
            DomainIntegral of_element = all_.interactions(place, k, local);
            of_element.J = own.dot(entered[k].q);
            result[entered[k].ring] += of_element;
        }
    };
    for (std::size_t place = 0; place < all_.first.size(); ++place) {
        const int element = all_.weights.elements()[place];
        if (!elements.in_zone().contains(element))
            elements.for_each(std::span(&element, 1), [&](const auto& op) { add(place, op); });
    }
    return result;
}

DomainIntegral RingForms::of_K(const Eigen::VectorXd& u) const {
    DomainIntegral sum = all_.interactions_in(first_for_K(rings_), u);
    sum += for_K_.interactions_in(first_for_K(rings_), u);
    sum.J = std::numeric_limits<double>::quiet_NaN();
    return sum;
}

DomainIntegral RingForms::Part::interactions_in(std::size_t ring, const Eigen::VectorXd& u) const {
    DomainIntegral sum;
    std::vector<double> local;
    for (std::size_t place = 0; place < first.size(); ++place) {
        const std::span<const RingWeights::Entered> entered = weights.of(place);
        const auto found = std::ranges::find(entered, ring - first_ring, &RingWeights::Entered::ring);
        if (found == entered.end()) continue;
        local.clear();
        for (std::size_t k = first_unknown[place]; k < first_unknown[place + 1]; ++k) local.push_back(u[unknowns[k]]);
        const Eigen::Map<const Eigen::VectorXd> element_u(local.data(), std::ssize(local));
        sum += interactions(place, at(found - entered.begin()), element_u);
    }
    return sum;
}

template <class Values>
DomainIntegral RingForms::Part::interactions(std::size_t place, std::size_t k, const Values& element_u) const {
    const Eigen::Index values = element_u.size();
    const double *const turning = &forms[first[place]],
                        *const of_ring = turning + values + static_cast<Eigen::Index>(k) * 3 * (values + 1),
                        *const turned = of_ring + 3 * values;
    const Eigen::Vector3d mutual = Eigen::Map<const Eigen::MatrixX3d>(of_ring, values, 3).transpose() * element_u;
    return {.interaction_I = mutual[0],
            .interaction_II = mutual[1],
            .interaction_T = mutual[2],
            .area = area[place],
            .rotation = Eigen::Map<const Eigen::VectorXd>(turning, values).dot(element_u),
            .turned_I = turned[0],
            .turned_II = turned[1],
            .turned_T = turned[2]};
}

std::vector<DomainIntegral> RingForms::values_with_initial_stress(const CoarseElements& elements,
                                                                  const Eigen::VectorXd& u) const {
    const Scene& scene = elements.scene();
    const Tip& about = scene.enriched.tips[at(tip_)];
    const Elasticity& elastic = scene.elastic(about);
    constexpr bool with_inside = true;
    RingSums sums(scene.enriched, about, elastic, rings_, elements.near(), with_inside);
    const Eigen::Matrix2d of_initial = gradient_of_initial_stress(scene.materials, about.position, about.material);
    elements.for_each(sums.elements(), [&](const auto& op) {
        sums.enter(op.element);
        const auto local = gather(u, op.unknowns);
        const MandelMatrix& stiffness = scene.stiffness(op.element);
        const int material = scene.enriched.material_of(op.element);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const Vec2& x = op.points[q].x;
            const Mandel stress = stiffness * op.strain(local, q) + scene.initial_stress(op.element, x);
            sums.add(op.points[q], stress, op.displacement_gradient(local, q) + of_initial, elastic.energy(stress));
            sums.add_initial(op.points[q], stress, scene.initial_stress().slope(x, about.material, about.direction));
            if (!scene.materials.are_alike(about.material, material))
                sums.add_mismatch(op.points[q], scene.materials.mismatch(about.material, material, x, stress));
        }
        sums.forget_points();
    });
    return {sums.values().begin(), sums.values().end()};
}

}  // namespace stria::coarse
