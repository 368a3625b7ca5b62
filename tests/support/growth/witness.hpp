// A fine component that is looked at before and after each change of its patch: what a growth step changes (act (a),
// docs/method.md, section 7).
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "coarse/model/scene.hpp"
#include "common/integration/element_operator.hpp"
#include "common/material/elasticity.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/growth/zone_view.hpp"

namespace stria::test {

/// Largest changes, relative to the largest value there is.
struct Change {
    double displacement = 0.0, stress = 0.0, plastic_strain = 0.0, jump = 0.0;
    double field = 0.0;     // of the displacement at points, by the functions of either mesh and all frozen ones
    double gradient = 0.0;  // what points say of it, against differences of the field
    double uneven = 0.0;    // in gradient: differs from point to point on a side of an element
    double refit = 0.0;     // of the energy, N
    double released = 0.0;  // N, in the equilibrium that follows
    bool grows = false;

    [[nodiscard]] double largest() const { return std::max({displacement, field, stress, plastic_strain, jump}); }
};

/// Hands everything on to the fine component of a case.
class GrowthWitness final : public coupling::FineScale {
public:
    explicit GrowthWitness(const Case& input) : input_(input), model_(input) {}

    void set_patch(const coupling::Patch& patch) override {
        if (!started_) {
            started_ = true;
            model_.set_patch(patch);
            return;
        }
        const ZoneView before(model_.system());
        model_.set_patch(patch);
        const ZoneView after(model_.system());
        changes.push_back(compare(before, after));
    }
    void request(const coupling::PatchDisplacement& displacement) override { model_.request(displacement); }
    coupling::PatchResponse collect() override { return model_.collect(); }
    coupling::StepReport commit(const coupling::Commit& what) override {
        coupling::StepReport report = model_.commit(what);
        if (const auto last = std::ranges::find(changes.rbegin(), changes.rend(), true, &Change::grows);
            last != changes.rend() && last->released == 0.0)
            last->released = report.energy.released;
        const ZoneView now(model_.system());
        for (const coupling::FaceSample& face : report.faces) {
            const FaceStation station = face_station_at(now.mesh, face.crack, face.s);
            misreported = std::max(misreported, std::abs(now.jump(station.x).dot(station.normal) - face.opening));
        }
        return report;
    }
    void rollback() override { model_.rollback(); }
    coupling::ZoneState state() override { return model_.state(); }
    coupling::ZoneSnapshot snapshot() override { return model_.snapshot(); }
    void restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) override {
        model_.restore(patch, snapshot);
    }

    std::vector<Change> changes;
    double misreported = 0.0;              // mm, of the openings of faces
    const coarse::Scene* scene = nullptr;  // of the last increment accepted
    Eigen::VectorXd structure_u;           // of the structure there

private:
    [[nodiscard]] Change compare(const ZoneView& before, const ZoneView& after) {
        Change change;
        for (std::size_t t = 0; t < after.mesh.tips.size(); ++t)
            change.grows = change.grows || !same_place(before.mesh.tips[t], after.mesh.tips[t]);
        compare_nodes(before, after, change);
        compare_points(before, after, change);
        compare_fields(before, after, change);
        compare_faces(before, after, change);
        return change;
    }

    static void compare_nodes(const ZoneView& before, const ZoneView& after, Change& change) {
        double largest = 0.0;
        for (int n = 0; n < std::ssize(after.mesh.nodes); ++n) {
            const auto old = std::ranges::find(before.mesh.node_ids, after.mesh.node_ids[at(n)]);
            if (old == before.mesh.node_ids.end() || after.mesh.follows(n, 0)) continue;
            const int m = static_cast<int>(old - before.mesh.node_ids.begin());
            const Vec2 was = before.u.segment<2>(before.mesh.unknown(m, 0, 0));
            largest = std::max(largest, was.norm());
            change.displacement =
                std::max(change.displacement, (after.u.segment<2>(after.mesh.unknown(n, 0, 0)) - was).norm());
        }
        change.displacement /= largest;
    }

    void compare_points(const ZoneView& before, const ZoneView& after, Change& change) const {
        double stress = 0.0, plastic = 1e-300;
        for (const auto& [id, e] : after.element) {
            const auto found = before.element.find(id);
            const std::size_t first = after.first_point[at(e)], end = after.first_point[at(e) + 1];
            if (found == before.element.end()) continue;
            const std::size_t was = before.first_point[at(found->second)],
                              was_end = before.first_point[at(found->second) + 1];
            for (std::size_t q = was; q < was_end; ++q) change.refit -= before.state.weight[q] * energy(before, q);
            for (std::size_t q = 0; q < end - first; ++q) {
                change.refit += after.state.weight[first + q] * energy(after, first + q);
                if (was + q >= was_end) continue;  // new: history of the nearest
                raise(change.stress, stress, before.stress(was + q), after.stress(first + q));
                raise(change.plastic_strain, plastic, before.plastic_strain(was + q), after.plastic_strain(first + q));
            }
        }
        change.stress /= stress;
        for (const auto& [id, e] : after.element)
            if (!before.element.contains(id)) change.stress = std::max(change.stress, misfit(after, id) / stress);
        change.plastic_strain /= plastic;
    }

    /// Points that stay where they are (new ones have a mean of what is around them).
    void compare_fields(const ZoneView& before, const ZoneView& after, Change& change) {
        double displacement = 0.0, gradient = 0.0;
        for (const auto& [id, e] : after.element) {
            const auto found = before.element.find(id);
            if (found == before.element.end()) continue;
            const std::size_t first = after.first_point[at(e)], was = before.first_point[at(found->second)];
            const std::size_t count =
                own_points_.try_emplace(id, before.first_point[at(found->second) + 1] - was).first->second;
            std::map<int, Eigen::Matrix2d> of_side;
            for (std::size_t q = 0; q < count; ++q) {
                if (after.state.weight[first + q] < 1e-9 * after.area(e)) continue;  // of a sliver
                const Vec2 x = after.place(first + q);
                const Vec2 is = after.displacement(e, x, after.state.side[first + q]),
                           had = before.displacement(found->second, x, before.state.side[was + q]);
                displacement = std::max(displacement, had.norm());
                change.field = std::max(change.field, (is - had).norm());
                const Eigen::Matrix2d off = after.gradient[first + q] - after.differences(e, first + q);
                gradient = std::max(gradient, after.gradient[first + q].norm());
                change.gradient = std::max(change.gradient, off.norm());
                const Eigen::Matrix2d& other = of_side.try_emplace(after.state.side[first + q], off).first->second;
                change.uneven = std::max(change.uneven, (off - other).norm());
            }
        }
        change.field /= displacement;
        change.gradient /= gradient;
        change.uneven /= gradient;
    }

    static void raise(double& change, double& largest, const auto& before, const auto& after) {
        change = std::max(change, (after - before).cwiseAbs().maxCoeff());
        largest = std::max(largest, before.cwiseAbs().maxCoeff());
    }

    /// An element that the structure gives up has the stresses that it had there.
    [[nodiscard]] double misfit(const ZoneView& after, int id) const {
        const int e = after.element.at(id);
        const std::size_t first = after.first_point[at(e)], end = after.first_point[at(e) + 1];
        const std::vector<int> piece = piece_of_elements(scene->enriched);
        const int own = piece[at(id)];
        const CrackPiece* cut = own >= 0 ? &scene->enriched.pieces[at(own)] : nullptr;
        IntegrationRule rule = elastic_rule(scene->enriched, id, cut != nullptr);
        rule.mean_dilatation = mean_dilatation(scene->input.material, scene->materials.elastic(0));
        const QuadNodes corners = ElementBasis(scene->enriched, id, cut != nullptr).corners();
        std::vector<IntegrationPoint> points;
        for (std::size_t q = first; q < end; ++q) {
            const Vec2 x(after.state.x[q], after.state.y[q]);
            points.push_back({x, map_to_parent(corners, x), after.state.weight[q], after.state.side[q], 0});
        }
        const ElementOperator op = make_operator(scene->enriched, id, cut, rule, points);
        const Eigen::VectorXd u = gather(structure_u, op.unknowns);
        double largest = 0.0;
        for (std::size_t q = first; q < end; ++q) {
            const Mandel was = scene->materials.elastic(0).stiffness() * op.strain(u, q - first);
            largest = std::max(largest, (after.stress(q) - was).norm());
        }
        return largest;
    }

    static void compare_faces(const ZoneView& before, const ZoneView& after, Change& change) {
        double largest = 0.0;
        for (const std::vector<Vec2>& places : {before.faces, after.faces}) {
            for (const Vec2& x : places) {
                largest = std::max(largest, before.jump(x).norm());
                change.jump = std::max(change.jump, (after.jump(x) - before.jump(x)).norm());
            }
        }
        change.jump /= largest;
    }

    [[nodiscard]] double energy(const ZoneView& of, std::size_t q) const {
        const double C = input_.material.kinematic.empty() ? 0.0 : input_.material.kinematic[0].C;
        return elasticity_of(input_.material, input_.model.plane).energy(of.stress(q)) +
               C / 3.0 * of.plastic_strain(q).squaredNorm();
    }

    const Case& input_;
    fine::FineModel model_;
    bool started_ = false;
    std::map<int, std::size_t> own_points_;  // of elements when they were first seen, by id
};

}  // namespace stria::test
