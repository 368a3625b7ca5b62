#include "common/case/schema/body_schema.hpp"

#include <map>
#include <string>

#include "common/case/checks/boundary_checks.hpp"
#include "common/case/checks/case_checks.hpp"
#include "common/case/checks/material_checks.hpp"
#include "common/schema/given.hpp"

namespace stria {

using schema::Given;
using schema::Place;
using schema::Section;
using schema::Value;

Section<ModelSection> model_section() {
    Section<ModelSection> s;
    s.choice<PlaneState>("plane", &ModelSection::plane,
                         {{"strain", PlaneState::Strain}, {"stress", PlaneState::Stress}})
        .says("Plane strain or plane stress.");
    s.value("thickness", &ModelSection::thickness)
        .in("mm")
        .positive()
        .says("Thickness of the body. Loads and results are per mm of it, and nothing depends on it.");
    return s;
}

namespace {

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

/// Either a specimen with its sizes, or a file and no more.
void check_mesh_source(const MeshSection& mesh, const Value& table, const Place& place) {
    const Given given{table, place};
    if (mesh.file) {
        for (const char* key : {"specimen", "width", "height", "size", "grading"})
            if (given.has(key)) given.refuse(key, "belongs to a specimen; the mesh is that of mesh.file");
        return;
    }
    if (mesh.specimen.empty()) given.refuse("needs specimen or file");
    for (const char* key : {"width", "size"})
        if (!given.has(key)) reject(place.inside(key), table.line, "is missing: a specimen needs it");
}

}  // namespace

Section<MeshSection> mesh_section() {
    Section<MeshSection> s;
    s.value("specimen", &MeshSection::specimen)
        .one_of({"sent", "mt", "ct", "plate"})
        .or_else("absent: the file's body")
        .says("A specimen of the catalogue.");
    s.value("file", &MeshSection::file)
        .says("Instead of a specimen: a mesh of Gmsh (.msh 4.1 or 2.2, ASCII or binary) or of Abaqus and CalculiX "
              "(.inp) with first-order triangles and quadrilaterals in mm, its path relative to the case file. Its "
              "groups name boundaries and regions; boundary edges of no group are \"unnamed\".");
    s.value("width", &MeshSection::width)
        .in("mm")
        .positive()
        .or_else("must be given for a specimen")
        .says("Width of the specimen, from the origin at its lower left corner; of ct W, from the origin on the load "
              "line at mid-height: 1.25 width in all.");
    s.value("height", &MeshSection::height)
        .in("mm")
        .positive()
        .or_else("4 width of sent, 3 width of mt, 1.2 width of ct")
        .says("Full height, ends included; of ct always 1.2 width.");
    s.value("size", &MeshSection::size)
        .in("mm")
        .positive()
        .or_else("must be given for a specimen")
        .says("Element edge far from every grading.");
    s.list("grading", &MeshSection::grading, grading_section())
        .says("Wishes for smaller elements near a point or a line; the smallest wish wins.");
    s.complete([](MeshSection& mesh) {
        if (mesh.height == 0.0) mesh.height = standard_height(mesh.specimen) * mesh.width;
    });
    s.leave_out({"specimen", "width", "height", "size", "grading"},
                [](const MeshSection& mesh) { return mesh.file.has_value(); });
    s.check(check_mesh_source);
    s.check(check_mesh);
    return s;
}

namespace {

Section<IsotropicHardening> isotropic_section() {
    using enum HardeningLaw;
    Section<IsotropicHardening> s;
    s.choice<HardeningLaw>("law", &IsotropicHardening::law,
                           {{"linear", Linear}, {"voce", Voce}, {"power", Power}, {"table", Table}})
        .says("Isotropic hardening: what R(p) adds to the yield stress. linear: modulus p. voce: Q (1 - exp(-b p)). "
              "power: Ramberg and Osgood's p = alpha reference / E (sigma / reference)^n, less p at the yield stress. "
              "table: straight lines.");
    s.value("modulus", &IsotropicHardening::modulus).in("MPa").at_least(0.0).says("linear: dR/dp.");
    s.value("Q", &IsotropicHardening::Q)
        .in("MPa")
        .says("voce: R at saturation; below zero the metal softens, by less than its yield stress.");
    s.value("b", &IsotropicHardening::b).at_least(0.0).says("voce: how fast R saturates.");
    s.value("n", &IsotropicHardening::n).at_least(0.0).says("power: the exponent, above 1.");
    s.value("alpha", &IsotropicHardening::alpha)
        .at_least(0.0)
        .says("power: p at the reference stress, in reference / E.");
    s.value("reference", &IsotropicHardening::reference)
        .in("MPa")
        .positive()
        .or_else("yield_stress")
        .says("power: the stress to which n and alpha refer.");
    s.value("plastic_strain", &IsotropicHardening::plastic_strain)
        .says("table: plastic strains, from 0 on, ascending.");
    s.value("stress", &IsotropicHardening::stress)
        .in("MPa")
        .says("table: the stresses, from yield_stress on, not falling; beyond the last it stays.");
    return s;
}

Section<KinematicHardening> kinematic_section() {
    Section<KinematicHardening> s;
    s.value("C", &KinematicHardening::C)
        .in("MPa")
        .at_least(0.0)
        .must_be_given()
        .says("Uniaxial modulus: dX = 2/3 C d(eps_p) - gamma X dp.");
    s.value("gamma", &KinematicHardening::gamma)
        .at_least(0.0)
        .says("Recall (Armstrong and Frederick); 0 is Prager's law.");
    s.value("C_start", &KinematicHardening::C_start)
        .in("MPa")
        .positive()
        .or_else("C")
        .says("C of the virgin metal: C + (C_start - C) exp(-C_rate p) stands for C then.");
    s.value("C_rate", &KinematicHardening::C_rate).at_least(0.0).says("How fast C_start becomes C with p.");
    s.value("threshold", &KinematicHardening::threshold)
        .says(
            "Recall at the limit C / gamma of the back stress alone (Ohno and Wang's first model): several such terms "
            "make a multilinear curve, and less ratcheting.");
    return s;
}

}  // namespace

Section<MaterialSection> material_section() {
    Section<MaterialSection> s;
    s.value("young", &MaterialSection::young)
        .in("MPa")
        .at_least(1e-6)
        .at_most(1e12)
        .must_be_given()
        .says("Young's modulus.");
    s.value("poisson", &MaterialSection::poisson).at_least(0.0).below(0.5).must_be_given().says("Poisson's ratio.");
    s.value("yield_stress", &MaterialSection::yield_stress)
        .in("MPa")
        .positive()
        .says("Initial yield stress; absent: elastic.");
    s.table("isotropic", &MaterialSection::isotropic, isotropic_section()).says("Isotropic hardening.");
    s.list("kinematic", &MaterialSection::kinematic, kinematic_section())
        .says("Kinematic hardening; the terms add up.");
    s.check(check_hardening);
    return s;
}

namespace {

Section<ContactSection> contact_section() {
    Section<ContactSection> s;
    s.value("friction", &ContactSection::friction).at_least(0.0).says("Coulomb's coefficient of friction.");
    s.choice<MultiplierKind>("multipliers", &ContactSection::multipliers,
                             {{"stable", MultiplierKind::Stable}, {"gauss", MultiplierKind::Gauss}})
        .says("stable: continuous pressures, coarser than the mesh. gauss: one at each Gauss point of the faces, for "
              "comparison: they oscillate.");
    s.value("smooth", &ContactSection::smooth)
        .in("mm")
        .says(
            "Two arc lengths from the crack's first point, between which its faces have no friction. Where that point "
            "is a tip and grows they go with it.");
    return s;
}

}  // namespace

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
        .says(
            "Arc length from the first point that is machined: no contact there. Where that point is a tip and grows, "
            "the notch stays where it is, and the new faces before it may touch.");
    s.check(check_crack);
    return s;
}

namespace {

Section<TravellingPressure> travelling_section() {
    Section<TravellingPressure> s;
    s.value("profile", &TravellingPressure::profile)
        .one_of({"hertz"})
        .says("hertz: p0 sqrt(1 - ((s - s_c) / half_width)^2).");
    s.value("p0", &TravellingPressure::p0).in("MPa").positive().must_be_given().says("Largest pressure.");
    s.value("half_width", &TravellingPressure::half_width)
        .in("mm")
        .positive()
        .must_be_given()
        .says("Half the width on which it presses.");
    s.value("friction", &TravellingPressure::friction)
        .says("Traction along the edge in pressures, towards growing s; negative: against it.");
    s.value("from", &TravellingPressure::from)
        .in("mm")
        .must_be_given()
        .says("Where its middle s_c is as a cycle begins: along the edge, towards growing x (y where it stands "
              "upright), from origin on.");
    s.value("to", &TravellingPressure::to)
        .in("mm")
        .must_be_given()
        .says("Where it is as the cycle ends; each increment takes it equally far.");
    return s;
}

}  // namespace

Section<BoundarySection> boundary_section() {
    Section<BoundarySection> s;
    s.value("on", &BoundarySection::on)
        .must_be_given()
        .says("A named edge of the specimen: top, bottom, left, right; a pin of ct: pin-top, pin-bottom; a group of "
              "mesh.file, or its \"unnamed\" edges; or \"point\".");
    s.value("at", &BoundarySection::at)
        .in("mm")
        .says("The point, with on = \"point\": a node of mesh.file; in a specimen one is put there, but in ct none "
              "within 0.2 width of a pin.");
    s.value("displacement", &BoundarySection::displacement).in("mm").says("Displacement per unit load factor.");
    s.value("traction", &BoundarySection::traction).in("MPa").says("Traction per unit load factor.");
    s.value("traction_gradient", &BoundarySection::traction_gradient)
        .in("MPa/mm")
        .says("Adds gradient (x - origin) to the traction: bending and linear stress fields.");
    s.value("origin", &BoundarySection::origin)
        .in("mm")
        .says("Where the gradient adds nothing, and places of travelling are zero.");
    s.value("pressure", &BoundarySection::pressure)
        .in("MPa")
        .says("Pressure per unit load factor, along the inward normal.");
    s.value("force", &BoundarySection::force)
        .in("N/mm")
        .says("Force at a point or pin, per thickness and unit load factor.");
    s.value("cosine", &BoundarySection::cosine)
        .says("Direction in which a pin or bolt presses: the pressure times the cosine between its own direction and "
              "this one, where that is positive. A pin of force F per mm in a hole of radius R has the pressure "
              "2 F / (pi R).");
    s.value("centre", &BoundarySection::centre)
        .in("mm")
        .says("With cosine: of the pin; the pressure is radial. Absent: it acts along the inward normal.");
    s.table("travelling", &BoundarySection::travelling, travelling_section())
        .says("A pressure that moves along the edge, once in each cycle of [load]. It is applied first and then kept; "
              "from one cycle to the next it fades out where it is and comes on where it begins.");
    s.value("case", &BoundarySection::load_case)
        .says("Name of the [[load_case]] whose factor multiplies the loads and displacements here. Absent: the load "
              "factor of [load].");
    s.check(check_boundary);
    return s;
}

}  // namespace stria
