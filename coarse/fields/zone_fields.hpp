// Structure and zone as one grid for ParaView: the crack visibly open, cut elements split along it.
#pragma once

#include "coarse/fields/vtk_files.hpp"
#include "coarse/structure/structure.hpp"
#include "coupling/messages.hpp"

namespace stria::coarse {

/// `u`: displacement of the whole mesh, zero inside the zone; `zone`: null without one; `faces`: of the same increment.
FieldData make_fields(const Structure& structure, const Eigen::VectorXd& u, const coupling::ZoneState* zone,
                      const std::vector<coupling::FaceSample>& faces);

}  // namespace stria::coarse
