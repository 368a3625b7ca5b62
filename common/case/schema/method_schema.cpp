#include "common/case/schema/method_schema.hpp"

namespace stria {

using schema::Section;

Section<SolverSection> solver_section() {
    Section<SolverSection> s;
    s.value("tolerance", &SolverSection::tolerance).positive().below(1.0).says("Relative residual at equilibrium.");
    s.value("max_iterations", &SolverSection::max_iterations)
        .at_least(1)
        .at_most(10'000)
        .says("Newton iterations before an increment is cut.");
    s.value("max_cuts", &SolverSection::max_cuts).at_least(0).at_most(40).says("Successive halvings of an increment.");
    return s;
}

Section<CouplingSection> coupling_section() {
    Section<CouplingSection> s;
    s.choice<StateCrosses>("state", &CouplingSection::state,
                           {{"auto", StateCrosses::WhereWanted},
                            {"increment", StateCrosses::EachIncrement},
                            {"newton", StateCrosses::EachIterate}})
        .says("When full internal-variable states cross: at commits that need them, at every increment or Newton "
              "iteration.");
    return s;
}

Section<FineSection> fine_section() {
    Section<FineSection> s;
    s.value("beta", &FineSection::beta)
        .positive()
        .says("Zone radius R_sub = beta (pi/16) K^2 / sigma_y^2, eq. (3); "
              "K^2 is K_I^2 + 3 K_II^2, the largest of the history.");
    s.value("radius", &FineSection::radius).in("mm").positive().says("A fixed zone radius instead of eq. (3).");
    s.value("refine", &FineSection::refine)
        .power_of_two()
        .at_most(most_refined)
        .says("Mesh size over element size at the tip.");
    s.value("growth", &FineSection::growth)
        .at_least(0.0)
        .below(0.3)
        .says(
            "With refine: elements within the zone's radius may be this times as large as they are far from the tip.");
    s.value("subcells", &FineSection::subcells)
        .at_least(1)
        .at_most(256)
        .or_else("2; with refine > 1, 1 away from the cracks and their way")
        .says("Sub-quadrangles per element edge, 2 x 2 Gauss points each.");
    s.value("substeps", &FineSection::substeps)
        .at_least(1)
        .at_most(10'000)
        .says("How finely a strain increment is taken at points that flow: in as many parts as leave the stress within "
              "0.4 % of the yield stress over this number, by the estimate of the return mapping, at most five times "
              "this number. 1: at once, by backward Euler. Linear hardening in plane strain returns exactly where it "
              "is more.");
    s.choice<Enrichment>("enrichment", &FineSection::enrichment,
                         {{"auto", Enrichment::Auto},
                          {"none", Enrichment::None},
                          {"single", Enrichment::Single},
                          {"topological", Enrichment::Topological},
                          {"geometrical", Enrichment::Geometrical}})
        .says(
            "Singular functions of the tip, eq. (2). none: the crack ends on an element edge near its tip. single: the "
            "first, on the tip's element. topological: all six there. geometrical: four within enrichment_radius, of "
            "elastic bodies without contact. auto: what docs/method.md, section 2, finds best.");
    s.value("enrichment_radius", &FineSection::enrichment_radius)
        .in("mm")
        .positive()
        .or_else("3/4 of the distance to the boundary, the middle to another tip or crack, or a bend; at least the "
                 "elements about that of the tip, which 1.15 element diagonals hold; at most 20 of them, and 1.25 less "
                 "than to that middle; where others leave no room for the least, the tip's element alone")
        .says("Radius of geometrical enrichment.");
    s.value("enrichment_n", &FineSection::enrichment_n)
        .at_least(1.0)
        .or_else("that of isotropic hardening by a power law alone, where no crack grows; else 1")
        .says("Hardening exponent n of the singular functions r^(1/(n+1)), geometrical ones aside.");
    s.choice<Guard>("guard", &FineSection::guard, {{"extend", Guard::Extend}, {"warn", Guard::Warn}})
        .says("When a coarse point yields: extend the zone and redo the increment, or warn.");
    return s;
}

Section<OutputSection> output_section() {
    const std::vector<std::pair<std::string, Written>> when = {
        {"extremes", Written::Extremes}, {"cycles", Written::Cycles}, {"all", Written::All}, {"none", Written::None}};
    Section<OutputSection> s;
    s.choice<Written>("faces", &OutputSection::faces, when)
        .says("Increments in faces.csv: max, zero and min of the last cycle (where growth ends a run unforeseen, where "
              "it does), those of every cycle, all or none.");
    s.choice<Written>("fields", &OutputSection::fields, when).says("Increments with field files, likewise.");
    s.choice<Written>("history", &OutputSection::history, {{"all", Written::All}, {"cycles", Written::Cycles}})
        .says(
            "Increments in history.csv: all, or extremes of the load and what growth releases. What is not written is "
            "not computed.");
    s.choice<FieldFormat>("format", &OutputSection::format,
                          {{"vtkhdf", FieldFormat::VtkHdf}, {"vtu", FieldFormat::Vtu}})
        .says("Format of the field files.");
    s.value("checkpoint_every", &OutputSection::checkpoint_every)
        .in("cycles")
        .at_least(0)
        .says("A checkpoint at the first extreme and after so many cycles, for --resume; 0: only at the end and where "
              "a run is interrupted or finds no equilibrium. auto: after 10 cycles, as long as checkpoints have taken "
              "less than a twentieth of the time of the run; else 10 cycles later.");
    return s;
}

}  // namespace stria
