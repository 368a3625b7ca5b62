// A case as the user writes it (docs/case-reference.md), one struct per section. Units N, mm, MPa throughout.
// Keys, units, ranges and sentences are declared once: body_schema, region_schema, load_schema and method_schema.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "common/case/load_sections.hpp"
#include "common/geometry/vec2.hpp"
#include "common/or_auto.hpp"

namespace stria {

enum class PlaneState { Strain, Stress };

struct ModelSection {
    PlaneState plane = PlaneState::Strain;
    double thickness = 1.0;  // mm
    bool operator==(const ModelSection&) const = default;
};

/// A wish for small elements near a point or an axis-parallel line: edge length `size` there, growing linearly to
/// `outer_size` at the distance `radius`, and by `growth` mm per mm of distance beyond. The smallest wish wins.
struct Grading {
    std::vector<Vec2> at;              // one point, or the two ends of a line
    double size = 0.0;                 // mm
    std::optional<double> outer_size;  // mm; absent: size
    double radius = 0.0;               // mm
    double growth = 0.25;              // mm per mm
    bool operator==(const Grading&) const = default;
};

/// Of a specimen of the catalogue, or of a file that holds the mesh itself.
struct MeshSection {
    std::string specimen;  // "sent" | "mt" | "ct" | "plate"; empty: the file's
    double width = 0.0;    // mm
    double height = 0.0;   // mm, full height; ct always has 1.2 width
    double size = 0.0;     // mm, element edge far from every grading
    std::vector<Grading> grading;
    std::optional<std::string> file = {};  // .msh or .inp; absolute once the case is read
    bool operator==(const MeshSection&) const = default;
};

enum class HardeningLaw { Linear, Voce, Power, Table };

struct IsotropicHardening {
    HardeningLaw law = HardeningLaw::Linear;
    double modulus = 0.0;                                  // MPa; linear: R = modulus p
    double Q = 0.0, b = 0.0;                               // MPa; voce: R = Q (1 - exp(-b p))
    double n = 0.0, alpha = 0.0;                           // power: p = alpha reference / E (sigma / reference)^n
    std::optional<double> reference = {};                  // MPa; absent: the yield stress
    std::vector<double> plastic_strain = {}, stress = {};  // table: MPa
    bool operator==(const IsotropicHardening&) const = default;
};

struct KinematicHardening {
    double C = 0.0;                      // MPa, uniaxial modulus
    double gamma = 0.0;                  // recall; 0: Prager
    bool threshold = false;              // recall at the limit C / gamma alone
    std::optional<double> C_start = {};  // MPa, of the virgin metal: C(p) = C + (C_start - C) exp(-C_rate p)
    double C_rate = 0.0;
    bool operator==(const KinematicHardening&) const = default;
};

struct MaterialSection {
    double young = 0.0;                  // MPa
    double poisson = 0.0;                //
    std::optional<double> yield_stress;  // MPa; absent: elastic
    IsotropicHardening isotropic;
    std::vector<KinematicHardening> kinematic;
    bool operator==(const MaterialSection&) const = default;
};

/// The stress that a region would have if nothing around it gave way, MPa.
struct MisfitStress {
    double xx = 0.0, yy = 0.0, xy = 0.0;
    bool operator==(const MisfitStress&) const = default;
};

/// Where the body is of another material than that of the case.
struct RegionSection {
    std::vector<Vec2> outline;  // a polygon, or two opposite corners of a rectangle, mm; empty: it is a group
    MaterialSection material;
    std::optional<MisfitStress> initial_stress;
    std::optional<std::string> group = {};  // of elements of mesh.file
    bool operator==(const RegionSection&) const = default;
};

/// Stress along an axis, linear between points.
struct StressProfile {
    std::vector<double> at;      // mm, ascending
    std::vector<double> stress;  // MPa, one per point
    bool operator==(const StressProfile&) const = default;
};

/// Stress at the nodes of a grid, bilinear between them.
struct StressGrid {
    std::vector<double> x, y;        // mm, ascending
    std::vector<double> xx, yy, xy;  // MPa, one per node, row by row: x fastest
    bool operator==(const StressGrid&) const = default;
};

/// The stress of the body before any load; what its parts give adds up.
struct InitialStressSection {
    std::optional<StressProfile> sigma_x, sigma_y;  // of y, and of x
    std::optional<std::string> file;                // a CSV file; its numbers become the grid
    std::optional<StressGrid> grid;
    bool operator==(const InitialStressSection&) const = default;
};

/// Stable beside the jumps of the faces; or one at each Gauss point of the interface elements, which is not.
enum class MultiplierKind { Stable, Gauss };

struct ContactSection {
    double friction = 0.0;  // Coulomb's coefficient
    MultiplierKind multipliers = MultiplierKind::Stable;
    std::vector<double> smooth = {};  // two arc lengths, mm, between which there is no friction; or none
    bool operator==(const ContactSection&) const = default;
};

struct CrackSection {
    std::vector<Vec2> points;               // polyline, mm
    std::optional<ContactSection> contact;  // absent: traction-free faces
    double notch = 0.0;                     // mm of arc from the first point without contact
    double grown_at_start = 0.0;            // mm of arc by which growth has moved that point on since; no key
    bool operator==(const CrackSection&) const = default;
};

struct BoundarySection {
    std::string on;                                               // a named edge of the mesh, or "point"
    std::optional<Vec2> at;                                       // mm, with on = "point"
    std::array<std::optional<double>, 2> displacement;            // mm per unit load factor; empty: free
    std::optional<Vec2> traction;                                 // MPa per unit load factor
    Eigen::Matrix2d traction_gradient = Eigen::Matrix2d::Zero();  // MPa/mm; t += gradient (x - origin)
    Vec2 origin = Vec2::Zero();
    std::optional<double> pressure;  // MPa per unit load factor, along the inward normal
    std::optional<Vec2> force;       // N per mm of thickness and unit load factor, at a point
    std::optional<Vec2> cosine;      // direction in which a pin presses: the pressure times the cosine to it, where > 0
    std::optional<Vec2> centre;      // mm, of the pin: the pressure is radial; absent: along the inward normal
    std::optional<TravellingPressure> travelling;
    std::optional<std::string> load_case;  // absent: that of [load]
    bool operator==(const BoundarySection&) const = default;
};

struct LoadBlock {
    int cycles = 1;
    double max = 0.0;
    double min = 0.0;  // from `min`, or ratio * max
    bool operator==(const LoadBlock&) const = default;
};

/// What the extremes of the blocks are: load factors, mean displacements of the loaded boundary, mm, or nominal stress
/// intensities of the first tip, MPa sqrt(mm).
enum class Control { Load, Displacement, StressIntensity };

struct LoadSection {
    OrAuto<int> steps = {};              // increments per cycle
    double accuracy = 0.002;             // where the program chooses them (IncrementSchedule)
    std::optional<double> grading = {};  // increment k of h ends at (k/h)^grading of the way between two reversals
    std::vector<LoadBlock> blocks;       // those of a spectrum file included
    std::optional<std::string> spectrum = {};  // a CSV file; its cycles follow those of the blocks
    double scale = 1.0;                        // of every max and min
    int repeat = 1;                            // of the whole sequence
    Control control = Control::Load;
    double K_gradient = 0.0;  // 1/mm, with control of K: K = block value exp(K_gradient (a - a at the start))
    [[nodiscard]] int first_steps() const { return steps.value_or(12); }  // to begin with
    [[nodiscard]] double power() const { return grading.value_or(steps.is_auto() ? 0.4 : 0.6); }
    bool operator==(const LoadSection&) const = default;
};

enum class TestControl { Strain, Stress };
/// Pulled along y with no other stress; in the plane state of the case with no stress along x; sheared.
enum class TestMode { Uniaxial, Plane, Shear };

/// The cycles of `stria material`.
struct MaterialTestSection {
    TestControl control = TestControl::Strain;
    TestMode mode = TestMode::Uniaxial;
    std::vector<LoadBlock> blocks;  // of strains, in shear twice the tensor's component, or of stresses, MPa
    int steps = 200;                // increments per cycle
    bool operator==(const MaterialTestSection&) const = default;
};

enum class GrowthAt { Maximum, Minimum };  // of a cycle, just reached

enum class GrowthLaw { Prescribed, Paris, Table, Ctod };
/// max(K_max, 0) - max(K_min, 0) (ASTM E647), K_max - K_min, K_max - K_op.
enum class GrowthDriving { Range, FullRange, EffectiveRange };
/// What becomes of a tip's functions where it has left: a fixed displacement, or unknowns still.
enum class Retain { Frozen, All };
enum class GrowthDirection { HoopStress, Straight };

struct GrowthSection {
    GrowthLaw law = GrowthLaw::Prescribed;
    OrAuto<double> increment = 0.0;                  // mm, of the fastest tip
    double accuracy = 0.02, zone_fraction = 0.0625;  // where the program chooses it (GrowthIncrement)
    int every = 1;                                   // cycles
    GrowthAt at = GrowthAt::Maximum;
    double C = 0.0, m = 0.0;  // Paris: da/dN = C dK^m, mm/cycle and MPa sqrt(mm); Ctod: da/dN = C (opening range)^m, mm
    std::optional<double> threshold = {};         // MPa sqrt(mm); Paris: no growth by a dK below
    std::vector<double> ranges = {}, rates = {};  // Table: dK, MPa sqrt(mm), and da/dN there, mm/cycle
    GrowthDriving driving = GrowthDriving::Range;
    double walker = 1.0;  // Range: K_max (1 - R)^walker, R >= 0
    GrowthDirection direction = GrowthDirection::HoopStress;
    Retain retain = Retain::Frozen;
    std::optional<double> until = {}, toughness = {};  // crack length, mm; MPa sqrt(mm)
    bool operator==(const GrowthSection&) const = default;
};

/// What the opening load is: where the last contact behind the tip is lost, where the compliance at the mouth leaves
/// that of the open crack, or where tension returns ahead of the tip.
enum class OpeningDefinition { Contact, Offset, Tension };

struct ClosureSection {
    std::optional<double> distance;  // mm behind the tip, or ahead of it
    OpeningDefinition definition = OpeningDefinition::Contact;
    std::vector<double> profile;  // mm: further distances behind the tip
    bool tension = false;         // measured too where another definition is used
    bool operator==(const ClosureSection&) const = default;
};

struct SolverSection {
    double tolerance = 2e-5;  // relative residual: a hundredth of LoadSection::accuracy
    int max_iterations = 25;  // Newton iterations before the increment is cut
    int max_cuts = 8;         // successive halvings of an increment
    bool operator==(const SolverSection&) const = default;
};

enum class Enrichment { Auto, None, Single, Topological, Geometrical };
enum class Guard { Extend, Warn };

struct FineSection {
    double beta = 2.0;
    std::optional<double> radius;  // mm
    int refine = 1;
    double growth = 0.15;  // of the element size with the distance to the tip
    std::optional<int> subcells;
    int substeps = 4;  // of a strain increment, at points that flow
    Enrichment enrichment = Enrichment::Auto;
    std::optional<double> enrichment_n;
    std::optional<double> enrichment_radius;  // mm, of geometrical enrichment
    Guard guard = Guard::Extend;
    bool operator==(const FineSection&) const = default;
};

/// When the state of all points crosses from the zone besides where it is wanted.
enum class StateCrosses { WhereWanted, EachIncrement, EachIterate };

struct CouplingSection {
    StateCrosses state = StateCrosses::WhereWanted;
    bool operator==(const CouplingSection&) const = default;
};

enum class Written { Extremes, Cycles, All, None };
enum class FieldFormat { VtkHdf, Vtu };

struct OutputSection {
    Written faces = Written::Extremes, fields = Written::Extremes, history = Written::All;
    FieldFormat format = FieldFormat::VtkHdf;
    OrAuto<int> checkpoint_every = {};  // cycles; 0: only at the end, and where a run is interrupted
    bool operator==(const OutputSection&) const = default;
};

struct Case {
    std::string name;  // the folder's name for .../name/case.toml, else the file's stem
    std::string title;
    ModelSection model;
    MeshSection mesh;
    MaterialSection material;
    std::vector<RegionSection> regions;
    std::optional<InitialStressSection> initial_stress;
    std::vector<CrackSection> cracks;
    std::vector<BoundarySection> boundaries;
    LoadSection load;
    std::vector<LoadCaseSection> load_cases;
    std::optional<GrowthSection> growth;
    ClosureSection closure;
    SolverSection solver;
    CouplingSection coupling;
    FineSection fine;
    OutputSection output;
    std::optional<MaterialTestSection> material_test;
    bool operator==(const Case&) const = default;
};

}  // namespace stria
