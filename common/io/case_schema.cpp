#include "common/io/case_schema.hpp"

#include <map>

namespace stria {

namespace {

using schema::Key;
using schema::Section;

Section<ModelSection> model_section() {
    Section<ModelSection> s;
    s.choice<PlaneState>("plane", &ModelSection::plane,
                         {{"strain", PlaneState::Strain}, {"stress", PlaneState::Stress}})
        .says("Plane strain or plane stress.");
    s.value("thickness", &ModelSection::thickness).in("mm").positive().says("Thickness of the body.");
    return s;
}

Section<Grading> grading_section() {
    Section<Grading> s;
    s.value("at", &Grading::at)
        .in("mm")
        .must_be_given()
        .says("A point [x, y], or the two ends of an axis-parallel line.");
    s.value("size", &Grading::size).in("mm").positive().must_be_given().says("Edge length of the elements there.");
    s.value("outer_size", &Grading::outer_size)
        .in("mm")
        .positive()
        .or_else("size")
        .says("Edge length at the distance radius.");
    s.value("radius", &Grading::radius)
        .in("mm")
        .at_least(0.0)
        .says("Up to here the edge length grows from size to outer_size.");
    s.value("growth", &Grading::growth)
        .in("mm/mm")
        .at_least(0.0)
        .says("Growth of the edge length per length beyond the radius.");
    s.check(check_grading);
    return s;
}

/// Height over width of a specimen in standard proportions; 0: it has none.
double standard_height(const std::string& specimen) {
    static const std::map<std::string, double> proportions{{"sent", 4.0}, {"mt", 3.0}, {"ct", 1.2}};
    const auto found = proportions.find(specimen);
    return found == proportions.end() ? 0.0 : found->second;
}

Section<MeshSection> mesh_section() {
    Section<MeshSection> s;
    s.value("specimen", &MeshSection::specimen)
        .one_of({"sent", "mt", "ct", "plate"})
        .must_be_given()
        .says("A specimen of the catalogue.");
    s.value("width", &MeshSection::width)
        .in("mm")
        .positive()
        .must_be_given()
        .says("Width of the specimen, from the origin at its lower left corner; of ct W, from the origin on the load "
              "line "
              "at mid-height: 1.25 width in all.");
    s.value("height", &MeshSection::height)
        .in("mm")
        .positive()
        .or_else("4 width of sent, 3 width of mt, 1.2 width of ct")
        .says("Full height, ends included; of ct always 1.2 width.");
    s.value("size", &MeshSection::size)
        .in("mm")
        .positive()
        .must_be_given()
        .says("Element edge far from every grading.");
    s.list("grading", &MeshSection::grading, grading_section())
        .says("Wishes for smaller elements near a point or a line; the smallest wish wins.");
    s.complete([](MeshSection& mesh) {
        if (mesh.height == 0.0) mesh.height = standard_height(mesh.specimen) * mesh.width;
    });
    s.check(check_mesh);
    return s;
}

Section<IsotropicHardening> isotropic_section() {
    Section<IsotropicHardening> s;
    s.value("law", &IsotropicHardening::law).one_of({"linear"}).says("Isotropic hardening law; linear: R = modulus p.");
    s.value("modulus", &IsotropicHardening::modulus).in("MPa").at_least(0.0).says("dR/dp.");
    return s;
}

Section<KinematicHardening> kinematic_section() {
    Section<KinematicHardening> s;
    s.value("C", &KinematicHardening::C)
        .in("MPa")
        .at_least(0.0)
        .must_be_given()
        .says("Uniaxial modulus: dX = 2/3 C d(eps_p) - gamma X dp.");
    s.value("gamma", &KinematicHardening::gamma).at_least(0.0).says("Recall; 0 is Prager's law.");
    return s;
}

Section<MaterialSection> material_section() {
    Section<MaterialSection> s;
    s.value("young", &MaterialSection::young).in("MPa").positive().must_be_given().says("Young's modulus.");
    s.value("poisson", &MaterialSection::poisson).at_least(0.0).below(0.5).must_be_given().says("Poisson's ratio.");
    s.value("yield_stress", &MaterialSection::yield_stress)
        .in("MPa")
        .positive()
        .says("Initial yield stress; absent: elastic.");
    s.table("isotropic", &MaterialSection::isotropic, isotropic_section()).says("Isotropic hardening.");
    s.list("kinematic", &MaterialSection::kinematic, kinematic_section())
        .says("Kinematic hardening; the terms add up.");
    return s;
}

Section<ContactSection> contact_section() {
    Section<ContactSection> s;
    s.value("friction", &ContactSection::friction).at_least(0.0).says("Coulomb's coefficient of friction.");
    return s;
}

Section<CrackSection> crack_section() {
    Section<CrackSection> s;
    s.value("points", &CrackSection::points)
        .in("mm")
        .must_be_given()
        .says("Polyline; ends strictly inside the body are tips, others are mouths. The plus face is to its left.");
    s.table("contact", &CrackSection::contact, contact_section())
        .says("Unilateral contact of the faces; absent: traction-free.");
    s.value("notch", &CrackSection::notch)
        .in("mm")
        .at_least(0.0)
        .says("Arc length from the first point that is machined: no contact there.");
    s.check(check_crack);
    return s;
}

Section<BoundarySection> boundary_section() {
    Section<BoundarySection> s;
    s.value("on", &BoundarySection::on)
        .must_be_given()
        .says(
            "A named edge of the specimen: top, bottom, left, right; a pin of ct: pin-top, pin-bottom; or \"point\".");
    s.value("at", &BoundarySection::at).in("mm").says("The point, with on = \"point\".");
    s.value("displacement", &BoundarySection::displacement).in("mm").says("Displacement per unit load factor.");
    s.value("traction", &BoundarySection::traction).in("MPa").says("Traction per unit load factor.");
    s.value("traction_gradient", &BoundarySection::traction_gradient)
        .in("MPa/mm")
        .says("Adds gradient (x - origin) to the traction: bending and linear stress fields.");
    s.value("origin", &BoundarySection::origin).in("mm").says("Where the gradient adds nothing.");
    s.value("pressure", &BoundarySection::pressure)
        .in("MPa")
        .says("Pressure per unit load factor, along the inward normal.");
    s.value("force", &BoundarySection::force)
        .in("N/mm")
        .says("Force at a point or pin, per thickness and unit load factor.");
    s.check(check_boundary);
    return s;
}

Section<LoadBlock> block_section() {
    Section<LoadBlock> s;
    s.value("cycles", &LoadBlock::cycles).at_least(1).says("Number of cycles.");
    s.value("max", &LoadBlock::max).must_be_given().says("Largest load factor, or displacement: see control.");
    s.value("min", &LoadBlock::min).or_else("ratio max").says("Smallest load factor, or displacement.");
    s.input("ratio", [](LoadBlock& block, double ratio) {
         block.min = ratio * block.max;
     }).says("Stands for min: min = ratio max.");
    s.check(check_block);
    return s;
}

Section<LoadSection> load_section() {
    Section<LoadSection> s;
    s.value("steps", &LoadSection::steps)
        .at_least(2)
        .even()
        .says("Increments per cycle; the first ramp takes half as many more.");
    s.value("grading", &LoadSection::grading)
        .positive()
        .says("Of the increments between two reversals: k of h ends at (k/h)^grading of the way; 1: equal ones, 0.6: "
              "large where little flows, small where much does.");
    s.list("blocks", &LoadSection::blocks, block_section())
        .says("Blocks of equal cycles, one after the other. A cycle runs from its maximum to its minimum and on to the "
              "maximum of the next one.");
    s.value("spectrum", &LoadSection::spectrum)
        .says("CSV file, relative to the case file, with a line of names: columns max, min and, if wanted, cycles; or "
              "one column turning_point. Its cycles follow the blocks; the resolved case lists them as blocks.");
    s.value("scale", &LoadSection::scale).positive().says("Multiplies every max and min.");
    s.value("repeat", &LoadSection::repeat).at_least(1).says("How often the whole sequence of blocks is gone through.");
    s.choice<Control>(
         "control", &LoadSection::control,
         {{"load", Control::Load}, {"displacement", Control::Displacement}, {"K", Control::StressIntensity}})
        .says("What max and min mean; load: the load factor. displacement: the mean displacement, mm, of the first "
              "listed boundary that carries a load, along it; the load factor follows, past a limit load too. K: the "
              "nominal "
              "K, MPa sqrt(mm), of the first tip; the load factor K / K_1(a) follows the growing crack.");
    s.value("K_gradient", &LoadSection::K_gradient)
        .in("1/mm")
        .says("With control = \"K\": K is that of the blocks times exp(K_gradient (a - a at the start)), ASTM E647.");
    return s;
}

Section<GrowthSection> growth_section() {
    Section<GrowthSection> s;
    s.choice<GrowthLaw>("law", &GrowthSection::law,
                        {{"prescribed", GrowthLaw::Prescribed}, {"paris", GrowthLaw::Paris}, {"ctod", GrowthLaw::Ctod}})
        .says("prescribed: by the increment. paris, ctod: by the increment too, slower tips in proportion, and the "
              "growth "
              "takes as many cycles as da/dN = C dK^m, or C dCTOD^m, needs for it (dN of cycles.csv).");
    s.value("increment", &GrowthSection::increment)
        .in("mm")
        .positive()
        .must_be_given()
        .says("What a tip, by a law of da/dN the fastest one, advances at a time.");
    s.value("every", &GrowthSection::every).at_least(1).says("Cycles from one advance to the next.");
    s.choice<GrowthAt>("at", &GrowthSection::at, {{"max", GrowthAt::Maximum}, {"min", GrowthAt::Minimum}})
        .says("At which extreme of the cycle the crack grows.");
    s.value("C", &GrowthSection::C).in("mm/cycle, MPa sqrt(mm) or mm").at_least(0.0).says("Of the law of da/dN.");
    s.value("m", &GrowthSection::m).at_least(0.0).says("Of the law of da/dN.");
    s.choice<Retain>("retain", &GrowthSection::retain, {{"frozen", Retain::Frozen}, {"all", Retain::All}})
        .says("Functions of a tip that has moved on: frozen: a fixed displacement. all: they stay unknowns, for "
              "comparison.");
    s.choice<GrowthDriving>("driving", &GrowthSection::driving,
                            {{"dK", GrowthDriving::Range}, {"dK_eff", GrowthDriving::EffectiveRange}})
        .says("What drives Paris' law: K_max - K_min, or K_max - K_op.");
    s.choice<GrowthDirection>("direction", &GrowthSection::direction,
                              {{"hoop", GrowthDirection::HoopStress}, {"straight", GrowthDirection::Straight}})
        .says("hoop: of the largest hoop stress; below K_II = 0.005 K_I straight on.");
    s.value("until", &GrowthSection::until).in("mm").positive().says("The run ends when a crack is as long.");
    s.value("toughness", &GrowthSection::toughness)
        .in("MPa sqrt(mm)")
        .positive()
        .says("The run ends when K_max of a tip reaches it.");
    s.check(check_growth);
    return s;
}

Section<ClosureSection> closure_section() {
    Section<ClosureSection> s;
    s.value("distance", &ClosureSection::distance)
        .in("mm")
        .positive()
        .or_else("a tenth of the radius of eq. (3) with beta = 1")
        .says("Contact nearer to the tip does not count; tension is the mean over this distance ahead of it.");
    s.choice<OpeningDefinition>("definition", &ClosureSection::definition,
                                {{"contact", OpeningDefinition::Contact},
                                 {"offset", OpeningDefinition::Offset},
                                 {"tension", OpeningDefinition::Tension}})
        .says(
            "What K_op of cycles.csv, U and dK_eff are. contact: the last contact behind the tip is lost. offset: the "
            "compliance at the mouth is 2 % below that of the open crack (E647). tension: the mean normal stress ahead "
            "of the tip becomes positive.");
    s.value("profile", &ClosureSection::profile)
        .in("mm")
        .positive()
        .says("Further distances behind the tip: their opening and closing loads go to closure.csv.");
    s.value("tension", &ClosureSection::tension).says("Measure the return of tension beside another definition.");
    return s;
}

Section<SolverSection> solver_section() {
    Section<SolverSection> s;
    s.value("tolerance", &SolverSection::tolerance).positive().below(1.0).says("Relative residual at equilibrium.");
    s.value("max_iterations", &SolverSection::max_iterations)
        .at_least(1)
        .says("Newton iterations before an increment is cut.");
    s.value("max_cuts", &SolverSection::max_cuts).at_least(0).says("Successive halvings of an increment.");
    return s;
}

Section<CouplingSection> coupling_section() {
    Section<CouplingSection> s;
    s.value("state", &CouplingSection::state)
        .one_of({"auto", "increment", "newton"})
        .says("When full internal-variable states cross: at commits that need them, at every increment or Newton "
              "iteration.");
    return s;
}

Section<FineSection> fine_section() {
    Section<FineSection> s;
    s.value("beta", &FineSection::beta).positive().says("Zone radius R_sub = beta (pi/16) K_I^2 / sigma_y^2, eq. (3).");
    s.value("radius", &FineSection::radius).in("mm").positive().says("A fixed zone radius instead of eq. (3).");
    s.value("refine", &FineSection::refine).power_of_two().says("Mesh size over element size at the tip.");
    s.value("growth", &FineSection::growth)
        .at_least(0.0)
        .below(0.3)
        .says(
            "With refine: elements within the zone's radius may be this times as large as they are far from the tip.");
    s.value("subcells", &FineSection::subcells)
        .at_least(1)
        .says("Sub-quadrangles per element edge, 2 x 2 Gauss points each.");
    s.value("substeps", &FineSection::substeps)
        .at_least(1)
        .says("Parts of a strain increment at points that flow: the return mapping is of first order in them.");
    s.choice<Enrichment>("enrichment", &FineSection::enrichment,
                         {{"auto", Enrichment::Auto},
                          {"none", Enrichment::None},
                          {"single", Enrichment::Single},
                          {"topological", Enrichment::Topological},
                          {"geometrical", Enrichment::Geometrical}})
        .says("Which nodes carry the singular functions of the tip.");
    s.value("enrichment_radius", &FineSection::enrichment_radius)
        .in("mm")
        .positive()
        .or_else("3/4 of the distance to the boundary, another tip or crack, or a bend; at most 20 element diagonals")
        .says("Radius of geometrical enrichment.");
    s.value("enrichment_n", &FineSection::enrichment_n)
        .at_least(1.0)
        .or_else("from the material")
        .says("Hardening exponent n of the singular functions.");
    s.choice<Guard>("guard", &FineSection::guard, {{"extend", Guard::Extend}, {"warn", Guard::Warn}})
        .says("When a coarse point yields: extend the zone and redo the increment, or warn.");
    return s;
}

Section<OutputSection> output_section() {
    const std::vector<std::pair<std::string, Written>> when = {
        {"extremes", Written::Extremes}, {"cycles", Written::Cycles}, {"all", Written::All}, {"none", Written::None}};
    Section<OutputSection> s;
    s.choice<Written>("faces", &OutputSection::faces, when)
        .says("Increments in faces.csv: max, zero and min of the last cycle, those of every cycle, all or none.");
    s.choice<Written>("fields", &OutputSection::fields, when).says("Increments with field files, likewise.");
    s.value("format", &OutputSection::format).one_of({"vtkhdf", "vtu"}).says("Format of the field files.");
    s.value("checkpoint_every", &OutputSection::checkpoint_every)
        .in("cycles")
        .at_least(0)
        .says("A checkpoint after so many cycles, for --resume; 0: only at the end and where a run is interrupted.");
    return s;
}

Section<Case> whole_case() {
    Section<Case> s;
    s.value("title", &Case::title).says("One line for reports.");
    s.value("name", &Case::name)
        .or_else("the folder of case.toml, or the file's stem")
        .says("Names the folder of results.");
    s.constant("units", "N-mm-MPa").says("the only system of units, units = \"N-mm-MPa\".");
    s.table("model", &Case::model, model_section()).says("Plane state and thickness.");
    s.table("mesh", &Case::mesh, mesh_section()).says("The specimen and its background mesh.");
    s.table("material", &Case::material, material_section()).says("Elasticity and J2 plasticity.");
    s.list("crack", &Case::cracks, crack_section()).says("Cracks.");
    s.list("boundary", &Case::boundaries, boundary_section()).says("Supports and loads.");
    s.table("load", &Case::load, load_section()).says("The history of the load factor.");
    s.table("growth", &Case::growth, growth_section()).says("How cracks grow; absent: they do not.");
    s.table("closure", &Case::closure, closure_section()).says("How opening and closing loads are measured.");
    s.table("solver", &Case::solver, solver_section()).says("Newton's method.");
    s.table("coupling", &Case::coupling, coupling_section()).says("The exchange between the two components.");
    s.table("fine", &Case::fine, fine_section()).says("The zones around the tips with plasticity and contact.");
    s.table("output", &Case::output, output_section()).says("What a run writes.");
    s.check(check_case);
    return s;
}

}  // namespace

const Section<Case>& case_schema() {
    static const Section<Case> schema = whole_case();
    return schema;
}

}  // namespace stria
