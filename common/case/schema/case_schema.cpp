#include "common/case/schema/case_schema.hpp"

#include "common/case/checks/case_checks.hpp"
#include "common/case/schema/body_schema.hpp"
#include "common/case/schema/load_schema.hpp"
#include "common/case/schema/method_schema.hpp"
#include "common/case/schema/region_schema.hpp"

namespace stria {

namespace {

using schema::Section;

Section<Case> whole_case() {
    Section<Case> s;
    s.value("title", &Case::title).says("One line for reports.");
    s.value("name", &Case::name)
        .or_else("the folder of case.toml, or the file's stem")
        .says("Names the folder of results.");
    s.constant("units", "N-mm-MPa").says("the only system of units, units = \"N-mm-MPa\".");
    s.table("model", &Case::model, model_section()).says("Plane state and thickness.");
    s.table("mesh", &Case::mesh, mesh_section()).says("The body and its background mesh: a specimen's, or a file's.");
    s.table("material", &Case::material, material_section()).says("Elasticity and J2 plasticity.");
    s.list("region", &Case::regions, region_section()).says("Parts of the body of another material.");
    s.table("initial_stress", &Case::initial_stress, initial_stress_section())
        .says("Stress before any load; absent: none. It comes to equilibrium in a first increment at the load factor "
              "0.");
    s.list("crack", &Case::cracks, crack_section()).says("Cracks.");
    s.list("boundary", &Case::boundaries, boundary_section()).says("Supports and loads.");
    s.table("load", &Case::load, load_section()).says("The history of the load factor.");
    s.list("load_case", &Case::load_cases, load_case_section())
        .says("Loads with a history of their own, beside that of [load].");
    s.table("growth", &Case::growth, growth_section()).says("How cracks grow; absent: they do not.");
    s.table("closure", &Case::closure, closure_section()).says("How opening and closing loads are measured.");
    s.table("solver", &Case::solver, solver_section()).says("Newton's method.");
    s.table("coupling", &Case::coupling, coupling_section()).says("The exchange between the two components.");
    s.table("fine", &Case::fine, fine_section()).says("The zones around the tips with plasticity and contact.");
    s.table("output", &Case::output, output_section()).says("What a run writes.");
    s.table("material_test", &Case::material_test, material_test_section())
        .says("Cycles of one material point, for stria material; a run does not look at them.");
    s.check(check_names_of_mesh);
    s.check(check_case);
    return s;
}

}  // namespace

const Section<Case>& case_schema() {
    static const Section<Case> schema = whole_case();
    return schema;
}

}  // namespace stria
