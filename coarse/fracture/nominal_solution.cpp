#include "coarse/fracture/nominal_solution.hpp"

namespace stria::coarse {

namespace {

Eigen::VectorXd near_displacement(const Structure& body, const LoadFactors& factors, double initial) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(body.scene().enriched.unknowns);
    body.expand_near({}, factors, initial, u);
    return u;
}

/// `unit`: at the load factor 1.
NominalFields fields_of(const Structure& body, Eigen::VectorXd unit) {
    const LinearReading& mean = body.loads().displacement_reading();
    NominalFields fields{.unit = std::move(unit),
                         .initial = {},
                         .of_cases = {},
                         .mean_displacement = mean.per_load_factor,
                         .mean_of_cases = mean.per_case,
                         .mean_of_initial = mean.constant};
    if (body.scene().enriched.tips.empty()) return fields;
    for (Eigen::Index k = 0; k < std::ssize(body.loads().cases()); ++k)
        fields.of_cases.push_back(near_displacement(body, LoadFactors::of_one_case(k), 0.0));
    if (body.scene().initial_stress().any()) fields.initial = near_displacement(body, 0.0, 1.0);
    return fields;
}

/// `tips`: those of the load factor 1.
std::vector<TipResult> with_other_loads(std::vector<TipResult> tips, const StructureRings& rings,
                                        const NominalFields& fields) {
    for (const Eigen::VectorXd& alone : fields.of_cases) {
        const std::vector<TipResult> of_case = nominal_K(rings, alone);
        for (std::size_t t = 0; t < tips.size(); ++t) {
            tips[t].K_I_of_cases.push_back(of_case[t].K_I);
            tips[t].K_II_of_cases.push_back(of_case[t].K_II);
        }
    }
    if (fields.initial.size() == 0) return tips;
    const std::vector<TipResult> initial =
        fracture_parameters(rings, fields.initial, rings.integrals(fields.initial), {});
    for (std::size_t t = 0; t < tips.size(); ++t) {
        tips[t].K_initial = initial[t].K_I;
        tips[t].K_II_initial = initial[t].K_II;
    }
    return tips;
}

}  // namespace

NominalSolution solve_nominal(std::unique_ptr<Structure> body) {
    NominalFields fields = fields_of(*body, body->expand({}, 1.0));
    StructureRings rings(body->elements());
    const RingIntegrals integrals = rings.integrals_of_displacement(fields.unit);
    std::vector<TipResult> tips =
        with_other_loads(fracture_parameters(rings, fields.unit, integrals, {}), rings, fields);
    return {nullptr, std::move(body), std::move(fields), std::move(tips), std::move(rings).take_forms()};
}

NominalSolution solve_nominal_near(std::unique_ptr<Structure> body, const ElementSet& for_K) {
    std::int64_t found = 0;  // of the work of a nominal solution nobody tells
    NominalFields fields = fields_of(*body, body->near_of_unit_load(found));
    StructureRings rings(body->elements(), StructureRings::forms_of(body->elements(), for_K));
    std::vector<TipResult> tips = with_other_loads(nominal_K(rings, fields.unit), rings, fields);
    return {nullptr, std::move(body), std::move(fields), std::move(tips), std::move(rings).take_forms()};
}

NominalSolution solve_nominal(const Scene& scene) {
    std::unique_ptr<const Scene> own = nominal_scene(scene);
    NominalSolution solution = solve_nominal(std::make_unique<Structure>(own ? *own : scene));
    solution.scene = std::move(own);
    return solution;
}

std::vector<double> stress_intensities(const std::vector<TipResult>& tips) {
    std::vector<double> K_I;
    for (const TipResult& tip : tips) K_I.push_back(tip.K_I);
    return K_I;
}

UnitResponse unit_response(const Scene& scene, const std::vector<TipResult>& tips,
                           const UnitDisplacement& displacement) {
    UnitResponse unit{.K_I = stress_intensities(tips), .displacement = displacement};
    for (const TipResult& tip : tips) {
        unit.K_II.push_back(tip.K_II);
        unit.K_initial.push_back(tip.K_initial);
        unit.K_II_initial.push_back(tip.K_II_initial);
        unit.K_I_of_cases.push_back(tip.K_I_of_cases);
        unit.K_II_of_cases.push_back(tip.K_II_of_cases);
    }
    for (const Tip& tip : scene.enriched.tips) {
        const std::optional<ContactSection>& contact = scene.input.cracks[at(tip.crack)].contact;
        unit.friction.push_back(contact ? std::optional(contact->friction) : std::nullopt);
    }
    return unit;
}

UnitDisplacement unit_displacement(const NominalFields& fields) {
    return {.mean = fields.mean_displacement,
            .largest = fields.unit.lpNorm<Eigen::Infinity>(),
            .of_cases = {fields.mean_of_cases.begin(), fields.mean_of_cases.end()},
            .initial = fields.mean_of_initial};
}

UnitResponse unit_response(const NominalSolution& nominal) {
    return unit_response(nominal.structure->scene(), nominal.tips, unit_displacement(nominal.fields));
}

}  // namespace stria::coarse
