// A zone's snapshot as the groups of a file (common/io/archive.hpp): tables by name; lists of small things in the bytes
// of the wire.
#pragma once

#include <cstddef>
#include <type_traits>

#include "coupling/transport/wire.hpp"

namespace stria::coupling {

template <class List> void as_bytes(auto& archive, const char* name, List& list) {
    std::vector<std::byte> bytes;
    if constexpr (std::remove_reference_t<decltype(archive)>::saves) {
        bytes = pack(list);
        archive(name, bytes);
    } else {
        archive(name, bytes);
        list = unpack<List>(bytes);
    }
}

void members(auto& archive, auto& snapshot) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(snapshot)>>, ZoneSnapshot> {
    auto& [ranks, element, rank, points, recent_flow, unknowns, resting, flow, stand, weighed_cost, columns, history,
           half_cycle_ended, displacement, rest_displacement, increments, held, multipliers, frozen_tips] = snapshot;
    archive("ranks", ranks);
    archive("element", element);
    archive("rank", rank);
    archive("points", points);
    archive("recent_flow", recent_flow);
    archive("unknowns", unknowns);
    archive("resting", resting);
    archive("flow", flow);
    archive("stand", stand);
    archive("weighed_cost", weighed_cost);
    archive("columns", columns);
    archive("history", history);
    archive("half_cycle_ended", half_cycle_ended);
    archive("displacement", displacement);
    archive("rest_displacement", rest_displacement);
    archive("increments", increments);
    archive("held", held);
    as_bytes(archive, "multipliers", multipliers);
    as_bytes(archive, "frozen_tips", frozen_tips);
}

}  // namespace stria::coupling
