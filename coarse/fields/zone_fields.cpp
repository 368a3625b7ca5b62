#include "coarse/fields/zone_fields.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "common/enrichment/element_basis.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/geometry/clipping.hpp"
#include "common/index.hpp"
#include "common/integration/cut_element.hpp"

namespace stria::coarse {
namespace {

/// Means over one element, or over one side of a cut one.
struct CellMean {
    double weight = 0.0;
    Mandel stress = Mandel::Zero(), plastic_strain = Mandel::Zero();
    double accumulated = 0.0;

    void add(double w, const Mandel& s, const Mandel& ep, double p) {
        weight += w;
        stress += w * s;
        plastic_strain += w * ep;
        accumulated += w * p;
    }
};

/// Sums over the faces in one element, and the largest status there.
struct FacesOfElement {
    int samples = 0;
    double pressure = 0.0, shear = 0.0, status = 0.0;

    void add(const coupling::FaceSample& sample) {
        ++samples;
        pressure += sample.pressure;
        shear += sample.shear;
        status = std::max<double>(status, sample.status);
    }
};

/// What the functions of an element make at a place, seen from a side of the crack, mm.
Vec2 displacement_at(const ElementBasis& basis, const Vec2& x, int side, const Eigen::VectorXd& u) {
    BasisValues values;
    basis.evaluate(map_to_parent(basis.corners(), x), x, side, values);
    Vec2 displacement = Vec2::Zero();
    for (int f = 0; f < basis.functions(); ++f)
        displacement += values.value[f] * u.segment<2>(basis.unknowns()[at(2 * f)]);
    return displacement;
}

using CellKey = std::pair<int, int>;  // element of the whole mesh, side

class FieldBuilder {
public:
    FieldBuilder(const Structure& structure, const Eigen::VectorXd& u, const coupling::ZoneState* zone,
                 const std::vector<coupling::FaceSample>& faces)
        : structure_(structure), mesh_(structure.scene().enriched), u_(u), whole_(mesh_.elements.size()),
          shared_(mesh_.nodes.size(), -1) {
        structure.elements().for_each([&](const auto& op) {
            const MandelMatrix& elastic = structure.scene().stiffness(op.element);
            const auto local = gather(u, op.unknowns);
            for (std::size_t q = 0; q < op.points.size(); ++q) {
                const Mandel stress =
                    structure.scene().initial_stress(op.element, op.points[q].x) + elastic * op.strain(local, q);
                mean({op.element, op.points[q].side}).add(op.points[q].weight, stress, Mandel::Zero(), 0.0);
            }
        });
        if (zone != nullptr) add_zone(*zone);
        add_faces(faces);
    }

    FieldData build() {
        const std::vector<int> piece = piece_of_elements(mesh_);
        for (int e = 0; e < static_cast<int>(mesh_.elements.size()); ++e) {
            if (piece[at(e)] < 0)
                add_plain(e);
            else
                add_cut(e, mesh_.pieces[at(piece[at(e)])]);
        }
        data_.point_arrays = {{"displacement", 3, std::move(displacement_)}};
        data_.cell_arrays = {{"stress", 4, std::move(stress_)},
                             {"von_mises", 1, std::move(von_mises_)},
                             {"plastic_strain", 4, std::move(plastic_)},
                             {"accumulated_plastic_strain", 1, std::move(accumulated_)},
                             {"zone", 1, std::move(zone_)},
                             {"crack_side", 1, std::move(side_)},
                             {"contact_pressure", 1, std::move(pressure_)},
                             {"contact_shear", 1, std::move(shear_)},
                             {"contact_status", 1, std::move(status_)}};
        return std::move(data_);
    }

private:
    void add_zone(const coupling::ZoneState& zone) {
        const EnrichedMesh part = extract(mesh_, structure_.in_zone().members());
        const std::vector<int> whole = whole_unknowns(mesh_, part);
        for (int i = 0; i < part.unknowns; ++i) u_[whole[at(i)]] = zone.displacement[i];
        for (std::size_t q = 0; q < zone.element.size(); ++q) {
            const Eigen::Map<const Mandel> stress(zone.stress.data() + 4 * q),
                plastic(zone.plastic_strain.data() + 4 * q);
            mean({part.element_ids[at(zone.element[q])], zone.side[q]})
                .add(zone.weight[q], stress, plastic, zone.accumulated[q]);
        }
        for (const coupling::FrozenTip& tip : zone.frozen_tips)
            for (int e = 0; e < std::ssize(tip.mesh.elements); ++e)
                frozen_[tip.mesh.element_ids[at(e)]].emplace_back(&tip, e);
    }

    // What the faces do inside each element that the crack crosses or runs along, or both: mean tractions, largest
    // status.
    void add_faces(const std::vector<coupling::FaceSample>& faces) {
        for (const CrackPiece& piece : mesh_.pieces)
            for (const coupling::FaceSample& sample : faces)
                if (sample.crack == piece.crack && sample.s >= piece.s.front() && sample.s <= piece.s.back())
                    faces_[piece.element].add(sample);
    }

    CellMean& mean(const CellKey& key) { return key.second == 0 ? whole_[at(key.first)] : sides_[key]; }

    // The points of a tip's element stay where they are, and none of them may stand on one side of the crack: a strip
    // beside an edge, say. What the other side holds goes on around the tip.
    const CellMean& mean_of_cell(const CellKey& key) {
        const CellMean& own = mean(key);
        return own.weight > 0.0 ? own : mean({key.first, -key.second});
    }

    void add_plain(int e) {
        // A node on the crack has two displacements; elements that touch the crack have points of their own.
        std::optional<ElementBasis> own;
        if (!is_plain(mesh_, e)) own.emplace(mesh_, e, false);
        if (own && mesh_.element_side[at(e)] == 0 && !own->enriched()) own.reset();
        std::vector<std::int64_t> points;
        for (const int node : mesh_.elements[at(e)])
            points.push_back(own ? add_point(*own, e, mesh_.nodes[at(node)], 0) : shared_point(node));
        add_cell(CellType::Quad, points, {e, 0});
    }

    // Terms vanish at nodes off the crack.
    std::int64_t shared_point(int node) {
        std::int64_t& point = shared_[at(node)];
        if (point < 0) point = add_point(mesh_.nodes[at(node)], u_.segment<2>(mesh_.unknown(node, 0, 0)));
        return point;
    }

    void add_cut(int e, const CrackPiece& piece) {
        const ElementBasis basis(mesh_, e, true);
        const CutElement cut = cut_element(basis.corners(), piece);
        std::vector<std::pair<Vec2, Vec2>> segments = cut.segments;
        segments.insert(segments.end(), cut.continuation.begin(), cut.continuation.end());
        const auto& corners = basis.corners();
        // Where the crack meets a slanted edge rounding leaves a triangle of no area beside it.
        const double none = 1e-13 * (corners[2] - corners[0]).squaredNorm();
        for (const auto& triangle : triangulate(corners, segments)) {
            if (cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 2.0 * none) continue;
            const int side = cut.side_of((triangle[0] + triangle[1] + triangle[2]) / 3.0);
            std::vector<std::int64_t> points;
            for (const Vec2& x : triangle) points.push_back(add_point(basis, e, x, side));
            add_cell(CellType::Triangle, points, {e, side});
        }
    }

    std::int64_t add_point(const ElementBasis& basis, int element, const Vec2& x, int side) {
        Vec2 displacement = displacement_at(basis, x, side, u_);
        if (const auto found = frozen_.find(element); found != frozen_.end())
            for (const auto& [tip, e] : found->second)
                displacement += displacement_at(ElementBasis(tip->mesh, e, true), x, side, tip->displacement);
        return add_point(x, displacement);
    }

    std::int64_t add_point(const Vec2& x, const Vec2& displacement) {
        data_.points.emplace_back(x.x(), x.y(), 0.0);
        displacement_.insert(displacement_.end(), {displacement.x(), displacement.y(), 0.0});
        return std::ssize(data_.points) - 1;
    }

    void add_cell(CellType type, const std::vector<std::int64_t>& points, const CellKey& key) {
        data_.add_cell(type, points);
        const CellMean& sum = mean_of_cell(key);
        const double w = sum.weight > 0.0 ? sum.weight : 1.0;
        const Mandel stress = sum.stress / w, plastic = sum.plastic_strain / w;
        for (int c = 0; c < 4; ++c) {
            const double scale = c == 3 ? 1.0 / std::numbers::sqrt2 : 1.0;  // tensor components xx, yy, zz, xy
            stress_.push_back(scale * stress[c]);
            plastic_.push_back(scale * plastic[c]);
        }
        von_mises_.push_back(stria::von_mises(stress));
        accumulated_.push_back(sum.accumulated / w);
        zone_.push_back(structure_.in_zone().contains(key.first) ? 1.0 : 0.0);
        side_.push_back(key.second);
        const auto found = faces_.find(key.first);
        const FacesOfElement faces = found != faces_.end() ? found->second : FacesOfElement();
        const int samples = std::max(faces.samples, 1);
        pressure_.push_back(faces.pressure / samples);
        shear_.push_back(faces.shear / samples);
        status_.push_back(faces.status);
    }

    const Structure& structure_;
    const EnrichedMesh& mesh_;
    Eigen::VectorXd u_;
    std::vector<CellMean> whole_;  // of uncut elements
    std::map<CellKey, CellMean> sides_;
    std::vector<std::int64_t> shared_;     // point of each node, -1: none yet
    std::map<int, FacesOfElement> faces_;  // by element
    // By element: functions that tips have left behind there, and which of their elements it is.
    std::map<int, std::vector<std::pair<const coupling::FrozenTip*, int>>> frozen_;
    FieldData data_;
    std::vector<double> displacement_, stress_, von_mises_, plastic_, accumulated_, zone_, side_, pressure_, shear_,
        status_;
};

}  // namespace

FieldData make_fields(const Structure& structure, const Eigen::VectorXd& u, const coupling::ZoneState* zone,
                      const std::vector<coupling::FaceSample>& faces) {
    return FieldBuilder(structure, u, zone, faces).build();
}

}  // namespace stria::coarse
