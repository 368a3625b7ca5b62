// Every message comes out as it went in, and broken bytes are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "common/error.hpp"
#include "common/geometry/vec2.hpp"
#include "coupling/transport/wire.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/whole_tangent.hpp"

namespace stria::coupling {
namespace {

EnrichedMesh small_mesh() {
    EnrichedMesh mesh;
    mesh.nodes = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0 / 3.0}, {0.0, 1.0}};
    mesh.elements = {{0, 1, 2, 3}};
    mesh.node_ids = {10, 11, 12, 13};
    mesh.element_ids = {5};
    mesh.pieces = {{.crack = 0,
                    .element = 0,
                    .neighbour = -1,
                    .points = {{0.0, 0.5}, {0.25, 0.5}},
                    .s = {0.0, 0.25},
                    .entry = 3.5,
                    .exit = -1.0}};
    mesh.tips = {{.crack = 0,
                  .position = {0.25, 0.5},
                  .direction = {1.0, 0.0},
                  .s = 0.25,
                  .upper = -1,
                  .beyond = 0.125,
                  .material = 2}};
    mesh.tip_functions = 6;
    mesh.terms = TermsOfNodes(4);
    mesh.terms.of(0) = {{Term::Kind::Heaviside, 0, 0, -1.0}, {Term::Kind::Tip, 0, 3, 0.7}};
    mesh.element_side = {1};
    mesh.material = {3};
    mesh.first_unknown = {0, 6, 8, 10};
    mesh.unknowns = 12;
    return mesh;
}

Patch small_patch() {
    return {.mesh = small_mesh(),
            .boundary = {0, 1, 6},
            .unit_load = Eigen::VectorXd::LinSpaced(12, 0.0, 3.0),
            .displacement = Eigen::VectorXd::LinSpaced(12, -0.1, 1.0 / 7.0),
            .rings = {{.tip = 0, .number = 1, .inner_radius = 1.5, .outer_radius = 2.5, .element = 0.5}},
            .opening_at = {0.25},
            .contact_at = {{0.25, 1.0}},
            .ahead = {0.125},
            .slip_at = {{0.25, 0.5}, {}},
            .shared = true,
            .part_of = {7}};
}

PatchResponse small_response() {
    PatchResponse response;
    response.force = Eigen::Vector3d(1.0, -2.0, 1e-300);
    response.tangent = {Eigen::Matrix3d{{1.0, 2.0, 3.0}, {2.5, 4.0, 5.0}, {3.0, 5.0, 6.0}}, Symmetry::General};
    response.unit_load = Eigen::Vector3d(0.0, 0.5, -0.25);
    response.interior_residual = 1e-9;
    response.contact_residual = 2e-9;
    response.digest = {
        .yielding_points = {0, 4, 2},
        .largest_plastic_increment = 1e-4,
        .status = {0, 1},
        .multiplier = {0.0, -3.5},
        .status_changes = 1,
        .contact = {{-1.0}, {0.25, 2.0}},
        .opening = {2e-3, 0.0},
        .force_ahead = {-7.5, 2.0},
        .nearest = {{{.behind = 0.25, .pressure = 40.0, .excess = -3.5, .closed = 7, .sliding = 2}, {}}, {}}};
    return response;
}

StepReport small_report() {
    StepReport report;
    report.tips = {{.CTOD = -1,
                    .opening = 2e-3,
                    .flow = {{.begin = 0.5, .end = 1.5, .reach = 1.25, .axis = 1.0}},
                    .flow_ever = {{.begin = 0.25, .end = 5.5, .reach = 5.0}}}};
    report.rings = {{.tip = 0,
                     .number = 2,
                     .sums = {.J = 1.0, .interaction_I = 2.0, .interaction_T = 3.0, .rotation = 4.0, .turned_T = 5.0}}};
    report.faces = {{.crack = 0, .s = 0.5, .opening = 1e-3, .pressure = 20.0, .status = 2}, {.crack = 1}};
    report.contact_length = {0.1, 0.2};
    report.mouth_opening = {std::numeric_limits<double>::quiet_NaN(), 0.3};
    report.energy = {.stored = 7.0, .released = 0.5, .contact = -0.125, .load_path = 0.25};
    report.points = 1'000'000'000'000;
    for_each_member(report.work, [value = std::int64_t{100}](auto, std::int64_t& count) mutable { count = ++value; });
    report.factor_s = 0.25;
    return report;
}

ZoneState small_state() {
    ZoneState state;
    state.displacement = Eigen::VectorXd::Constant(2, 0.1);
    state.element = {0, 0};
    state.side = {-1, 1};
    state.x = {0.1, 0.2};
    state.stress = std::vector<double>(8, 3.0);
    state.frozen_tips = {{.mesh = small_mesh(), .displacement = Eigen::VectorXd::Ones(12), .crack = 1}};
    return state;
}

/// Packed again it has the same bytes; every shorter or longer message is refused.
template <class M> M there_and_back(const M& message) {
    std::vector<std::byte> bytes = pack(message);
    const M copy = unpack<M>(bytes);
    EXPECT_EQ(pack(copy), bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW((void)unpack<M>(std::span(bytes).first(size)), ComponentLost) << size;
    bytes.push_back(std::byte{0});
    EXPECT_THROW((void)unpack<M>(bytes), ComponentLost);
    return copy;
}

TEST(Wire, Patch) {
    const Patch copy = there_and_back(small_patch());
    EXPECT_EQ(copy.mesh.nodes, small_mesh().nodes);
    EXPECT_EQ(copy.mesh.elements, small_mesh().elements);
    EXPECT_EQ(copy.mesh.pieces.at(0).points, small_mesh().pieces.at(0).points);
    EXPECT_EQ(copy.mesh.pieces.at(0).entry, 3.5);
    EXPECT_EQ(copy.mesh.tips.at(0).upper, -1);
    EXPECT_EQ(copy.mesh.tips.at(0).beyond, 0.125);
    EXPECT_EQ(copy.mesh.tips[0].material, 2);
    EXPECT_EQ(copy.mesh.material, std::vector<int>{3});
    EXPECT_EQ(copy.mesh.terms[0].at(1).kind, Term::Kind::Tip);
    EXPECT_EQ(copy.mesh.terms[0].at(1).shift, 0.7);
    EXPECT_EQ(copy.mesh.element_side, small_mesh().element_side);
    EXPECT_EQ(copy.mesh.unknowns, 12);
    EXPECT_EQ(copy.boundary, small_patch().boundary);
    EXPECT_EQ(copy.displacement, small_patch().displacement);
    EXPECT_EQ(copy.unit_load, small_patch().unit_load);
    EXPECT_EQ(copy.rings.at(0).number, 1);
    EXPECT_EQ(copy.rings.at(0).outer_radius, 2.5);
    EXPECT_EQ(copy.contact_at, small_patch().contact_at);
    EXPECT_EQ(copy.slip_at, small_patch().slip_at);
    EXPECT_EQ(copy.ahead, small_patch().ahead);
    EXPECT_EQ(copy.opening_at, small_patch().opening_at);
}

TEST(Wire, Restore) {
    ZoneSnapshot snapshot;
    snapshot.ranks = 3;
    snapshot.element = {5};
    snapshot.rank = {2};
    snapshot.points = {1};
    snapshot.columns = 2;
    snapshot.history = {0.1, -0.0};
    snapshot.half_cycle_ended = true;
    snapshot.displacement = Vec2(1e-300, 2.0);
    snapshot.increments = {Vec2(1.0, 2.0), Vec2(3.0, 4.0)};
    snapshot.held = Vec2(0.0, -5.0);
    snapshot.multipliers = {{.crack = 1,
                             .place = {0.5, 0.25},
                             .shear = -0.5,
                             .status = 3,
                             .widened = -1.5,
                             .slid = 0.5,
                             .until_met = 0.75,
                             .settled_slip = -0.375,
                             .increments = {0.1, 0.2},
                             .shear_increments = {0.3}}};
    snapshot.frozen_tips = {{.mesh = small_mesh(), .displacement = Eigen::VectorXd::Ones(12), .crack = 1}};
    const Restore copy = there_and_back(Restore{small_patch(), snapshot});
    EXPECT_EQ(copy.snapshot.rank, snapshot.rank);
    EXPECT_TRUE(std::signbit(copy.snapshot.history.at(1)));
    EXPECT_TRUE(copy.snapshot.half_cycle_ended);
    EXPECT_EQ(copy.snapshot.increments, snapshot.increments);
    EXPECT_EQ(copy.snapshot.held, snapshot.held);
    EXPECT_EQ(copy.snapshot.multipliers.at(0).place, Vec2(0.5, 0.25));
    EXPECT_EQ(copy.snapshot.multipliers[0].shear, -0.5);
    EXPECT_EQ(copy.snapshot.multipliers[0].status, 3);
    EXPECT_EQ(copy.snapshot.multipliers[0].widened, -1.5);
    EXPECT_EQ(copy.snapshot.multipliers[0].slid, 0.5);
    EXPECT_EQ(copy.snapshot.multipliers[0].until_met, 0.75);
    EXPECT_EQ(copy.snapshot.multipliers[0].settled_slip, -0.375);
    EXPECT_EQ(copy.snapshot.multipliers[0].shear_increments, snapshot.multipliers[0].shear_increments);
    EXPECT_EQ(copy.snapshot.multipliers[0].increments, snapshot.multipliers[0].increments);
    EXPECT_EQ(copy.snapshot.frozen_tips.at(0).mesh.nodes, small_mesh().nodes);
}

TEST(Wire, Displacement) {
    const PatchDisplacement message{.iteration = 4, .predictor = 0.3, .load_factor = -0.7, .boundary = Vec2(0.1, -0.0)};
    const PatchDisplacement copy = there_and_back(message);
    EXPECT_EQ(copy.iteration, 4);
    EXPECT_EQ(copy.predictor, 0.3);
    EXPECT_EQ(copy.load_factor, -0.7);
    EXPECT_EQ(copy.boundary, message.boundary);
    EXPECT_TRUE(std::signbit(copy.boundary[1]));
}

TEST(Wire, Response) {
    const PatchResponse copy = there_and_back(small_response());
    EXPECT_EQ(copy.force, small_response().force);
    EXPECT_EQ(copy.tangent.matrix, small_response().tangent.matrix);
    EXPECT_EQ(copy.tangent.symmetry, Symmetry::General);
    EXPECT_EQ(copy.unit_load, small_response().unit_load);
    EXPECT_EQ(copy.contact_residual, 2e-9);
    EXPECT_EQ(copy.digest.yielding_points, small_response().digest.yielding_points);
    EXPECT_EQ(copy.digest.multiplier, small_response().digest.multiplier);
    EXPECT_EQ(copy.digest.status_changes, 1);
    EXPECT_EQ(copy.digest.nearest, small_response().digest.nearest);
    EXPECT_EQ(copy.digest.opening, small_response().digest.opening);
}

TEST(Wire, Report) {
    const StepReport copy = there_and_back(small_report());
    EXPECT_EQ(copy.tips.at(0).opening, 2e-3);
    EXPECT_EQ(copy.tips.at(0).flow_ever.at(0).reach, 5.0);
    EXPECT_EQ(copy.tips.at(0).flow.at(0).reach, 1.25);
    EXPECT_EQ(copy.tips.at(0).flow.at(0).axis, 1.0);
    EXPECT_EQ(copy.faces.at(0).status, 2);
    EXPECT_EQ(copy.faces.at(1).crack, 1);
    EXPECT_TRUE(std::isnan(copy.mouth_opening.at(0)));
    EXPECT_EQ(copy.energy.stored, 7.0);
    EXPECT_EQ(copy.energy.released, 0.5);
    EXPECT_EQ(copy.energy.contact, -0.125);
    EXPECT_EQ(copy.energy.load_path, 0.25);
    EXPECT_EQ(copy.points, 1'000'000'000'000);
    for_each_member(copy.work, [value = std::int64_t{100}](std::string_view name, std::int64_t count) mutable {
        EXPECT_EQ(count, ++value) << name;
    });
    EXPECT_EQ(copy.factor_s, 0.25);
}

TEST(Wire, State) {
    const ZoneState copy = there_and_back(small_state());
    EXPECT_EQ(copy.side, small_state().side);
    EXPECT_EQ(copy.stress, small_state().stress);
    EXPECT_EQ(copy.frozen_tips.at(0).crack, 1);
}

TEST(Wire, SmallMessages) {
    EXPECT_EQ(there_and_back(Hello{3, 0xffff'ffff'ffff'fff0}).case_digest, 0xffff'ffff'ffff'fff0);
    EXPECT_EQ(there_and_back(Failure{Failure::Kind::Case, "why"}).text, "why");
    const Commit commit =
        there_and_back(Commit{.reversal = true, .bends = true, .next_over_this = 2.0, .no_faces = true});
    EXPECT_TRUE(commit.reversal);
    EXPECT_TRUE(commit.bends);
    EXPECT_EQ(commit.next_over_this, 2.0);
    EXPECT_FALSE(commit.brief);
    EXPECT_TRUE(commit.no_faces);
}

TEST(Wire, EmptyMessages) {
    there_and_back(Patch{});
    there_and_back(PatchResponse{});
    there_and_back(StepReport{});
    there_and_back(ZoneState{});
}

TEST(Wire, ASymmetricTangentCrossesAsHalfOfIt) {
    constexpr Eigen::Index n = 50;
    PatchResponse response;
    response.tangent = {Eigen::MatrixXd::Random(n, n), Symmetry::General};
    const Eigen::MatrixXd& matrix = response.tangent.matrix;
    const std::size_t all = pack(response).size();
    EXPECT_EQ(unpack<PatchResponse>(pack(response)).tangent.matrix, matrix);

    response.tangent.matrix.triangularView<Eigen::StrictlyUpper>() = matrix.transpose();
    response.tangent.symmetry = Symmetry::Symmetric;
    EXPECT_LT(pack(response).size(), all - n * (n - 1) / 2 * sizeof(double));
    const CondensedTangent copy = unpack<PatchResponse>(pack(response)).tangent;
    EXPECT_EQ(test::whole(copy), matrix);
    EXPECT_EQ(copy.symmetry, Symmetry::Symmetric);
}

TEST(Wire, ABrokenLengthAsksForNoMemory) {
    std::vector<std::byte> bytes = pack(ZoneState{});
    for (std::size_t i = 0; i < 7; ++i) bytes[i] = std::byte{0xff};
    EXPECT_THROW((void)unpack<ZoneState>(bytes), ComponentLost);
}

TEST(Wire, AnUnforeseenMessageIsNamed) {
    EXPECT_NO_THROW(expect(Tag::Done, Tag::Done));
    EXPECT_EQ(test::refusal_of<ComponentLost>([] { expect(Tag::Response, Tag::Report); }),
              "the components lost step: Response expected, Report received");
}

}  // namespace
}  // namespace stria::coupling
