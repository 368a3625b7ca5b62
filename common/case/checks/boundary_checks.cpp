#include "common/case/checks/boundary_checks.hpp"

#include <array>

namespace stria {

using schema::Given;
using schema::Place;
using schema::Value;

namespace {

enum class Carrier { Edge, Point, Pin };

/// Where only the names of a specimen tell what carries.
enum class Body { Any, Specimen };

/// Of a key that this carrier does not take.
struct Demand {
    Carrier carrier;
    const char *key, *text;
    Body body = Body::Any;
};

constexpr const char* an_edge = "needs an edge, not a point";

constexpr std::array demands = {
    Demand{Carrier::Edge, "at", "needs on = \"point\""},
    Demand{Carrier::Pin, "at", "needs on = \"point\""},
    Demand{Carrier::Point, "traction", an_edge},
    Demand{Carrier::Point, "pressure", an_edge},
    Demand{Carrier::Point, "traction_gradient", an_edge},
    Demand{Carrier::Edge, "force", "needs on = \"point\" or a pin", Body::Specimen},
    Demand{Carrier::Pin, "displacement", "needs an edge or a point: a pin turns freely and carries a force",
           Body::Specimen},
    Demand{Carrier::Pin, "traction", an_edge, Body::Specimen},
    Demand{Carrier::Pin, "pressure", an_edge, Body::Specimen},
    Demand{Carrier::Pin, "traction_gradient", an_edge, Body::Specimen},
};

Carrier carrier_of(const BoundarySection& boundary) {
    if (boundary.on == "point") return Carrier::Point;
    return boundary.on.starts_with("pin-") ? Carrier::Pin : Carrier::Edge;
}

/// A gradient of zero says nothing.
bool says(const BoundarySection& boundary, const Given& given, std::string_view key) {
    if (key == "traction_gradient" && boundary.traction_gradient.isZero(0.0)) return false;
    return given.has(key);
}

void check_carrier(const BoundarySection& boundary, const Given& given, Body body) {
    for (const Demand& demand : demands)
        if (demand.body == body && demand.carrier == carrier_of(boundary) && says(boundary, given, demand.key))
            given.refuse_value(demand.key, demand.text);
}

void check_cosine(const BoundarySection& boundary, const Given& given) {
    const auto demand = [&](bool met, const char* key, const char* what) {
        if (!met && given.has(key)) given.refuse(key, what);
    };
    demand(boundary.pressure.has_value(), "cosine", "needs a pressure that it distributes");
    demand(!boundary.cosine || boundary.cosine->norm() > 0.0, "cosine", "must not be zero: it is a direction");
    demand(boundary.cosine.has_value(), "centre", "needs cosine");
}

void check_travelling(const BoundarySection& boundary, const Given& given) {
    if (!boundary.travelling) return;
    if (carrier_of(boundary) != Carrier::Edge) given.refuse("travelling", "needs an edge, not a point or pin");
    for (const char* key : {"displacement", "traction", "pressure", "force", "case", "traction_gradient"})
        if (says(boundary, given, key))
            given.refuse(key, "does not go with travelling: give it a [[boundary]] of its own");
    if (boundary.travelling->from == boundary.travelling->to)
        reject(given.place.inside("travelling.to"), find(given.table, "travelling")->line, "must differ from from");
}

bool says_something(const BoundarySection& boundary) {
    return boundary.displacement[0] || boundary.displacement[1] || boundary.traction || boundary.pressure ||
           boundary.force || boundary.travelling;
}

}  // namespace

void check_boundary(const BoundarySection& boundary, const Value& table, const Place& place) {
    const Given given{table, place};
    if (boundary.on == "point" && !boundary.at) given.refuse("on = \"point\" needs at = [x, y]");
    check_carrier(boundary, given, Body::Any);
    check_cosine(boundary, given);
    check_travelling(boundary, given);
    if (!says_something(boundary) && !given.has("traction_gradient"))
        given.refuse("needs a displacement, traction, pressure or force");
}

void check_boundary_of_specimen(const BoundarySection& boundary, const Given& given) {
    check_carrier(boundary, given, Body::Specimen);
}

}  // namespace stria
