#include "common/case/schema/load_schema.hpp"

#include <utility>

#include "common/case/checks/case_checks.hpp"
#include "common/case/checks/material_checks.hpp"
#include "common/case/loads/load_case_checks.hpp"
#include "common/schema/auto_values.hpp"

namespace stria {

using schema::Section;

namespace {

/// Adds the extremes of a block; `max`, `min`: what they say.
Section<LoadBlock> with_extremes(Section<LoadBlock> s, const char* max, const char* min) {
    s.value("max", &LoadBlock::max).must_be_given().says(max);
    s.value("min", &LoadBlock::min).or_else("ratio max").says(min);
    s.input("ratio", [](LoadBlock& block, double ratio) {
         block.min = ratio * block.max;
     }).says("Stands for min: min = ratio max.");
    s.check(check_block);
    return s;
}

Section<LoadBlock> block_section() {
    Section<LoadBlock> s;
    s.value("cycles", &LoadBlock::cycles).at_least(1).says("Number of cycles.");
    return with_extremes(std::move(s), "Largest load factor, or displacement: see control.",
                         "Smallest load factor, or displacement.");
}

Section<LoadBlock> test_block_section() {
    Section<LoadBlock> s;
    s.value("cycles", &LoadBlock::cycles).at_least(1).at_most(1'000'000).says("Number of cycles.");
    return with_extremes(std::move(s), "Largest strain, or stress in MPa: see control.", "Smallest strain or stress.");
}

void declare_increments(Section<LoadSection>& s) {
    s.value("steps", &LoadSection::steps)
        .at_least(2)
        .at_most(100'000)
        .even()
        .says("Increments per cycle; the first ramp takes half as many more. auto: 12 in the first cycle, then as many "
              "as accuracy wants, from 4 to 24 between two reversals; where a load from above zero goes on into "
              "compression 32 in the first cycles, then up to 40 between two reversals. It stays at 12 "
              "where no opening behind a tip is known, and at 24 with load cases that lag. Where a pressure travels "
              "there are so many that each takes it on by no more than a quarter of its half width.");
    s.value("accuracy", &LoadSection::accuracy)
        .positive()
        .below(1.0)
        .says(
            "With steps = \"auto\": by how much of its range the opening behind a tip, at closure.distance, may be off "
            "at the end of a half cycle. Half cycles get the increments for a third of this error, and for a sixth "
            "where faces are pressed together, since what those are off by adds up as a crack grows. The error is "
            "measured now and then, by two increments tried as one. Below the default there may be up to four times as "
            "many increments. A run warns where even the most of them leave more than half of this error. Errors of "
            "0.4 % were seen before the first measurement, which is in the fourth cycle, and where faces close less "
            "than 1.2 elements behind the tip in compression; K_op was then off by 0.002 of K_max at most.");
    s.value("grading", &LoadSection::grading)
        .positive()
        .or_else("1 where the load presses faces with friction, by more than a hundredth of the largest K; else 0.4 "
                 "with steps = \"auto\", 0.6 with a number")
        .says("Of the increments between two reversals: k of h ends at (k/h)^grading of the way; 1: equal ones, 0.4: "
              "large where little flows, small where the load turns. Where load cases lag and this is absent, equal "
              "angles of the cycle.");
}

void declare_sequence(Section<LoadSection>& s) {
    s.list("blocks", &LoadSection::blocks, block_section())
        .says("Blocks of equal cycles, one after the other. A cycle runs from its maximum to its minimum and on to the "
              "maximum of the next one.");
    s.value("spectrum", &LoadSection::spectrum)
        .says("CSV file, relative to the case file, with a line of names: columns max, min and, if wanted, cycles; or "
              "one column turning_point, and beside it columns with the names of load cases. A cycle is a maximum and "
              "the minimum after it: turning points before the first maximum and after the last minimum are left "
              "out, unless load.repeat lets them follow on the end of the file. Its cycles follow the blocks; the "
              "resolved case lists them as blocks.");
    s.value("scale", &LoadSection::scale)
        .positive()
        .says("Multiplies every max and min of [load]; load cases have factors of their own.");
    s.value("repeat", &LoadSection::repeat).at_least(1).says("How often the whole sequence of blocks is gone through.");
}

void declare_control(Section<LoadSection>& s) {
    s.choice<Control>(
         "control", &LoadSection::control,
         {{"load", Control::Load}, {"displacement", Control::Displacement}, {"K", Control::StressIntensity}})
        .says("What max and min mean; load: the load factor. displacement: the displacement, mm, of the first listed "
              "boundary that carries a load, along it: what the loads there do work on, over their resultant, its mean "
              "where they are even (of a body that nothing holds there: what all loads do work on, over the force); "
              "the load factor follows, past a limit load too, and the first half cycle goes on from where dead loads "
              "and an initial stress have moved the boundary. K: the nominal K, MPa sqrt(mm), of the first tip; the "
              "load factor K / K_1(a) follows the growing crack.");
    s.value("K_gradient", &LoadSection::K_gradient)
        .in("1/mm")
        .says("With control = \"K\": K is that of the blocks times exp(K_gradient (a - a at the start)), ASTM E647.");
}

}  // namespace

Section<LoadSection> load_section() {
    Section<LoadSection> s;
    declare_increments(s);
    declare_sequence(s);
    declare_control(s);
    return s;
}

namespace {

Section<CaseBlock> case_block_section() {
    Section<CaseBlock> s;
    s.value("cycles", &CaseBlock::cycles).at_least(1).says("Number of cycles.");
    s.value("at_max", &CaseBlock::at_max).must_be_given().says("Factor at the maximum of the cycle of [load].");
    s.value("at_min", &CaseBlock::at_min).must_be_given().says("Factor at its minimum.");
    return s;
}

}  // namespace

Section<LoadCaseSection> load_case_section() {
    Section<LoadCaseSection> s;
    s.value("name", &LoadCaseSection::name).must_be_given().says("What boundary.case calls it.");
    s.value("constant", &LoadCaseSection::constant)
        .says("Factor of a dead load: applied before the first maximum of [load], in half as many increments as a "
              "cycle has, then kept.");
    s.value("factor", &LoadCaseSection::factor)
        .says("The factor is this times the history of [load], behind which it lags by phase.");
    s.value("phase", &LoadCaseSection::phase)
        .at_least(0.0)
        .below(360.0)
        .says("Degrees of a cycle by which it lags behind [load]; 90: it is at its maximum midway between the maximum "
              "and the minimum of [load]. An increment ends there.");
    s.choice<LagPath>("path", &LoadCaseSection::path, {{"sine", LagPath::Sine}, {"triangle", LagPath::Triangle}})
        .says("How both go from turn to turn, seen over the angle of a cycle: with sine and a phase of 90 they run "
              "through an ellipse, with triangle through a rhombus.");
    s.list("blocks", &LoadCaseSection::blocks, case_block_section())
        .says("Its factors at the extremes of the cycles of [load], as many cycles as there; straight in between. A "
              "case that has none of constant, factor and blocks is the column of its name in load.spectrum.");
    s.check(check_load_case);
    return s;
}

Section<MaterialTestSection> material_test_section() {
    Section<MaterialTestSection> s;
    s.choice<TestControl>("control", &MaterialTestSection::control,
                          {{"strain", TestControl::Strain}, {"stress", TestControl::Stress}})
        .says("What max and min mean: strains, or stresses in MPa.");
    s.choice<TestMode>("mode", &MaterialTestSection::mode,
                       {{"uniaxial", TestMode::Uniaxial}, {"plane", TestMode::Plane}, {"shear", TestMode::Shear}})
        .says("uniaxial: one stress and no other. plane: pulled in the plane state of the case, with no stress across. "
              "shear: the angle gamma and the stress tau.");
    s.list("blocks", &MaterialTestSection::blocks, test_block_section())
        .says("Blocks of equal cycles, one after the other, as in load.blocks.");
    s.value("steps", &MaterialTestSection::steps)
        .at_least(2)
        .at_most(100'000)
        .even()
        .says("Equal increments per cycle, half of them for each branch; the ramp to the first maximum takes half as "
              "many more.");
    s.check(check_material_test);
    return s;
}

namespace {

void declare_growth_increments(Section<GrowthSection>& s) {
    s.choice<GrowthLaw>("law", &GrowthSection::law,
                        {{"prescribed", GrowthLaw::Prescribed},
                         {"paris", GrowthLaw::Paris},
                         {"table", GrowthLaw::Table},
                         {"ctod", GrowthLaw::Ctod}})
        .says("prescribed: by the increment. paris, table, ctod: by the increment too, slower tips in proportion, and "
              "the growth takes as many cycles as da/dN needs for it (dN of cycles.csv): C dK^m, what ranges and rates "
              "say of dK, or C (opening range at closure.distance behind the tip)^m.");
    s.value("increment", &GrowthSection::increment)
        .in("mm")
        .positive()
        .must_be_given()
        .says(
            "What a tip, by a law of da/dN the fastest one, advances at a time. auto, with such a law: as accuracy and "
            "zone_fraction let it, and one element where opening loads or an opening range drive the growth and faces "
            "end on edges of elements; it never passes until.");
    s.value("accuracy", &GrowthSection::accuracy)
        .positive()
        .below(1.0)
        .says(
            "With increment = \"auto\": an increment is at most twice the one before, and smaller where the life that "
            "it takes, relative to it, or K_op / K_max may be off by more than this. A run warns where its N may be, "
            "however increments are chosen.");
    s.value("zone_fraction", &GrowthSection::zone_fraction)
        .positive()
        .at_most(1.0)
        .says(
            "With increment = \"auto\": largest increment, of what the forward plastic zone of the cycle before "
            "extends straight ahead; of the crack's length a hundredth where nothing flows. The smallest is an element "
            "at the tip.");
    s.value("every", &GrowthSection::every)
        .at_least(1)
        .says(
            "Cycles from one advance to the next. By a law of da/dN under a load that varies: as many as the sequence "
            "that it repeats, for a growth takes the mean rate of its cycles.");
    s.choice<GrowthAt>("at", &GrowthSection::at, {{"max", GrowthAt::Maximum}, {"min", GrowthAt::Minimum}})
        .says("At which extreme of the cycle the crack grows.");
}

void declare_law(Section<GrowthSection>& s) {
    s.value("C", &GrowthSection::C).in("mm/cycle, MPa sqrt(mm) or mm").at_least(0.0).says("paris, ctod: of the law.");
    s.value("m", &GrowthSection::m).at_least(0.0).says("paris, ctod: of the law.");
    s.value("threshold", &GrowthSection::threshold)
        .in("MPa sqrt(mm)")
        .positive()
        .or_else("none")
        .says("paris: no growth by a dK below.");
    s.value("ranges", &GrowthSection::ranges)
        .in("MPa sqrt(mm)")
        .says(
            "table: dK, ascending; no growth below the first. Straight lines between the logarithms; the last one goes "
            "on.");
    s.value("rates", &GrowthSection::rates).in("mm/cycle").says("table: da/dN at these, ascending.");
}

void declare_tips(Section<GrowthSection>& s) {
    s.choice<Retain>("retain", &GrowthSection::retain, {{"frozen", Retain::Frozen}, {"all", Retain::All}})
        .says(
            "Functions of a tip that has moved on: frozen: a fixed displacement. all: they stay unknowns, for "
            "comparison, where it has moved by 0.22 of an element and more. A body of which nothing may yield forgets "
            "them.");
    s.choice<GrowthDriving>("driving", &GrowthSection::driving,
                            {{"dK", GrowthDriving::Range},
                             {"dK_full", GrowthDriving::FullRange},
                             {"dK_eff", GrowthDriving::EffectiveRange}})
        .says("What drives paris and table. dK: max(K_max, 0) - max(K_min, 0), as in E647. dK_full: K_max - K_min, "
              "compression too. dK_eff: K_max - K_op; without contact that is dK.");
    s.value("walker", &GrowthSection::walker)
        .at_least(0.0)
        .at_most(1.0)
        .says("With driving = \"dK\": Walker's exponent w of the load ratio. K_max (1 - R)^w drives, R = K_min / K_max "
              "where K_min > 0, else 0; 1: dK. C, m, threshold and ranges are those of R = 0.");
    s.choice<GrowthDirection>("direction", &GrowthSection::direction,
                              {{"hoop", GrowthDirection::HoopStress}, {"straight", GrowthDirection::Straight}})
        .says("hoop: of the largest hoop stress of all loads and the initial stress, at the maximum of a cycle (of one "
              "load never above zero at its minimum); straight on within 1e-4 of an element. straight: as it begins.");
}

void declare_ends(Section<GrowthSection>& s) {
    s.value("until", &GrowthSection::until)
        .in("mm")
        .positive()
        .says("The run ends when a crack is as long, and none is as it begins. By a law of da/dN the last increment is "
              "cut to it.");
    s.value("toughness", &GrowthSection::toughness)
        .in("MPa sqrt(mm)")
        .positive()
        .says(
            "The run ends when K_max of a tip reaches it, or what K_II makes of K behind a sharp turn if that is more "
            "(with direction = \"hoop\"). By a law of da/dN the last increment is cut to where it "
            "does.");
}

}  // namespace

Section<GrowthSection> growth_section() {
    Section<GrowthSection> s;
    declare_growth_increments(s);
    declare_law(s);
    declare_tips(s);
    declare_ends(s);
    s.check(check_growth);
    return s;
}

Section<ClosureSection> closure_section() {
    Section<ClosureSection> s;
    s.value("distance", &ClosureSection::distance)
        .in("mm")
        .positive()
        .or_else("of each tip a tenth of the radius of eq. (3) with beta = 1 and its largest K_I as the crack begins, "
                 "or behind the sharp turn that it takes first; closure_distance of summary.json")
        .says("Contact nearer to the tip does not count; the opening is read there; tension is the mean over this "
              "distance ahead of the tip.");
    s.choice<OpeningDefinition>("definition", &ClosureSection::definition,
                                {{"contact", OpeningDefinition::Contact},
                                 {"offset", OpeningDefinition::Offset},
                                 {"tension", OpeningDefinition::Tension}})
        .says(
            "What K_op of cycles.csv, U and dK_eff are. contact: the last contact behind the tip is lost. offset: the "
            "compliance at the mouth is 2 % below that of the open crack (E647); needs load.steps. tension: the mean "
            "normal stress ahead of the tip becomes positive.");
    s.value("profile", &ClosureSection::profile)
        .in("mm")
        .positive()
        .says("Further distances behind the tip: loads of opening, closing and slip go to closure.csv.");
    s.value("tension", &ClosureSection::tension).says("Measure the return of tension beside another definition.");
    return s;
}

}  // namespace stria
