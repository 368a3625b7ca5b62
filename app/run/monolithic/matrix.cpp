#include "app/run/monolithic/matrix.hpp"

#include "common/index.hpp"

namespace stria {

SparseMatrix MonolithicMatrix::assembled() const {
    Entries entries;
    add_bulk(entries);
    add_contact(entries);
    add_held_and_target(entries);
    const int size = scene.enriched.unknowns + zone.contact().tractions() + 1;
    SparseMatrix matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

void MonolithicMatrix::add(Entries& entries, int row, int column, double value) const {
    const bool is_held = row < scene.enriched.unknowns && held[at(row)] != 0;
    if (!is_held && value != 0.0) entries.emplace_back(row, column, value);
}

void MonolithicMatrix::add_bulk(Entries& entries) const {
    for (int j = 0; j < scene.enriched.unknowns; ++j)
        for (SparseMatrix::InnerIterator it(stiffness, j); it; ++it)
            add(entries, static_cast<int>(it.row()), j, it.value());
    for (int e = 0; e < zone.bulk().elements().count(); ++e) {
        const auto& unknowns = zone.bulk().elements().op(e).unknowns;
        const Eigen::MatrixXd& K = zone.bulk().tangent(e);
        for (std::size_t i = 0; i < unknowns.size(); ++i) {
            for (std::size_t j = 0; j < unknowns.size(); ++j) {
                add(entries, whole[at(unknowns[i])], whole[at(unknowns[j])],
                    K(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
            }
        }
    }
}

void MonolithicMatrix::add_contact(Entries& entries) const {
    const int n = scene.enriched.unknowns;
    const fine::ContactInterface& contact = zone.contact();
    const int own = static_cast<int>(whole.size());  // unknowns of the zone
    for (int k = 0; k < contact.multipliers(); ++k) {
        std::vector<int> unknowns = contact.unknowns_of(k, own);
        for (int& unknown : unknowns) unknown = unknown < own ? whole[at(unknown)] : n + unknown - own;
        const Eigen::MatrixXd matrix = contact.matrix_of(k);
        for (Eigen::Index i = 0; i < matrix.rows(); ++i)
            for (Eigen::Index j = 0; j < matrix.cols(); ++j)
                add(entries, unknowns[at(i)], unknowns[at(j)], matrix(i, j));
        if (!fine::is_closed(contact.statuses()[at(k)])) add_push(entries, k);  // of what they lose
    }
}

void MonolithicMatrix::add_push(Entries& entries, int k) const {
    const fine::FaceOperators& contact = zone.contact().operators();
    const int n = scene.enriched.unknowns;
    for (SparseRows::InnerIterator it(contact.operator_B(), k); it; ++it)
        add(entries, whole[at(it.col())], n + k, -it.value());
    for (SparseRows::InnerIterator it(contact.operator_T(), k); it; ++it)
        add(entries, whole[at(it.col())], n + contact.shear_of(k), it.value());
}

// K du - f dlambda = R; a held unknown moves with the load factor; what is controlled goes to its target.
void MonolithicMatrix::add_held_and_target(Entries& entries) const {
    const int n = scene.enriched.unknowns, lambda = n + zone.contact().tractions();
    for (int i = 0; i < n; ++i) {
        add(entries, i, lambda, -scene.unit_force[i]);
        if (held[at(i)] != 0) entries.emplace_back(i, i, 1.0);
        if (controlled.weights[i] != 0.0) entries.emplace_back(lambda, i, controlled.weights[i]);
    }
    for (const auto& p : scene.prescribed) entries.emplace_back(p.unknown, lambda, -p.value);
    entries.emplace_back(lambda, lambda, controlled.per_load_factor);
}

}  // namespace stria
