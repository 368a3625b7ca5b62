// A zone as it is at one moment: displacement, its gradients and the states of its points, to compare with another.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "common/enrichment/element_basis.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/index.hpp"
#include "common/integration/crack_faces.hpp"
#include "fine/zone/zone_system.hpp"
#include "tests/support/cracked_mesh.hpp"

namespace stria::test {

/// Copies what it shows, so that the system may go on.
class ZoneView {
public:
    explicit ZoneView(const fine::ZoneSystem& system)
        : mesh(system.patch().mesh), u(system.bulk().committed_displacement()), frozen(system.frozen()),
          state(system.state()), piece_(piece_of_elements(mesh)) {
        const auto& operators = system.bulk().operators();
        for (std::size_t e = 0; e < operators.size(); ++e) {
            element[mesh.element_ids[e]] = static_cast<int>(e);
            first_point.push_back(gradient.size());
            for (const auto& point : system.bulk().committed_states(static_cast<int>(e)))
                gradient.push_back(point.gradient);
        }
        first_point.push_back(gradient.size());
        for (const FaceStation& station : system.contact().operators().stations()) faces.push_back(station.x);
    }

    [[nodiscard]] Vec2 jump(const Vec2& x) const {
        const auto s = arc_length_at(mesh, 0, x);
        return s ? Vec2(face_station_at(mesh, 0, *s).jump(u) + frozen.jump(0, x)) : Vec2::Zero();
    }
    [[nodiscard]] Vec2 place(std::size_t point) const { return {state.x[point], state.y[point]}; }
    [[nodiscard]] Mandel stress(std::size_t point) const { return Mandel(state.stress.data() + 4 * point); }
    [[nodiscard]] Mandel plastic_strain(std::size_t point) const {
        return Mandel(state.plastic_strain.data() + 4 * point);
    }

    [[nodiscard]] double area(int e) const {
        double sum = 0.0;
        for (std::size_t q = first_point[at(e)]; q < first_point[at(e) + 1]; ++q) sum += state.weight[q];
        return sum;
    }

    /// The displacement at x as the functions in element e have it, on a side of the crack: those of the mesh, and all
    /// that are frozen. Nothing of a point's history.
    [[nodiscard]] Vec2 displacement(int e, const Vec2& x, int side) const {
        Vec2 sum = sum_of_functions(mesh, e, piece_[at(e)] >= 0, u, x, side);
        for (const coupling::FrozenTip& tip : frozen.tips()) {
            const auto found = std::ranges::find(tip.mesh.element_ids, mesh.element_ids[at(e)]);
            if (found == tip.mesh.element_ids.end()) continue;
            const int own = static_cast<int>(found - tip.mesh.element_ids.begin());
            sum += sum_of_functions(tip.mesh, own, piece_in(tip.mesh, own) != nullptr, tip.displacement, x, side);
        }
        return sum;
    }

    /// Central differences of it at a point of element e (row: component).
    [[nodiscard]] Eigen::Matrix2d differences(int e, std::size_t point) const {
        const Vec2 x = place(point);
        double way = (mesh.nodes[at(mesh.elements[at(e)][2])] - mesh.nodes[at(mesh.elements[at(e)][0])]).norm();
        for (const Tip& tip : mesh.tips) way = std::min(way, (tip.position - x).norm());
        for (const coupling::FrozenTip& old : frozen.tips())
            for (const Tip& tip : old.mesh.tips) way = std::min(way, (tip.position - x).norm());
        const double h = 1e-4 * way;
        Eigen::Matrix2d slope;
        for (const int along : {0, 1}) {
            const Vec2 step = h * Vec2::Unit(along);
            slope.col(along) =
                (displacement(e, x + step, state.side[point]) - displacement(e, x - step, state.side[point])) /
                (2.0 * h);
        }
        return slope;
    }

    EnrichedMesh mesh;
    Eigen::VectorXd u;
    fine::FrozenTips frozen;
    coupling::ZoneState state;
    std::vector<Eigen::Matrix2d> gradient;  // per point, as its history has it
    std::vector<Vec2> faces;                // places of the face stations, crack by crack
    std::map<int, int> element;             // by id
    std::vector<std::size_t> first_point;   // of each element

private:
    static Vec2 sum_of_functions(const EnrichedMesh& mesh, int e, bool cut, const Eigen::VectorXd& u, const Vec2& x,
                                 int side) {
        const ElementBasis basis(mesh, e, cut);
        BasisValues values;
        basis.evaluate(map_to_parent(basis.corners(), x), x, side, values);
        Vec2 sum = Vec2::Zero();
        for (int f = 0; f < basis.functions(); ++f) sum += values.value[f] * u.segment<2>(basis.unknowns()[at(2 * f)]);
        return sum;
    }

    std::vector<int> piece_;  // of each element
};

}  // namespace stria::test
