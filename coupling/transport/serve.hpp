// The fine component's side of a conversation: reads questions and has a FineScale answer them.
#pragma once

#include <cstdint>

#include "coupling/fine_scale.hpp"
#include "coupling/transport/transport.hpp"

namespace stria::coupling {

/// Shakes hands (throws as RemoteFineScale's constructor does), then answers until the other side says stop.
/// NumericalFailure and CaseError of `fine` cross as answers and the conversation goes on; anything else ends it and is
/// thrown.
void serve(Transport& transport, FineScale& fine, std::uint64_t case_digest);

}  // namespace stria::coupling
